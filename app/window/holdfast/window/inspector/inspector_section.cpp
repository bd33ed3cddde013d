#include "holdfast/window/inspector/inspector_section.h"

#include <cmath>
#include <utility>

#include <holdfast/words/error.h>

namespace holdfast {

InspectorSection::InspectorSection(Editor& editor, const QString& title)
    : editor_(editor), lines_(newLayout<QVBoxLayout>(this, 0, 6))
{
  auto* label = new QLabel("<b>" + title + "</b>");
  label->setContentsMargins(0, 8, 0, 0);
  lines_->addWidget(label);
}

void InspectorSection::inspect(const Rows& rows)
{
  rows_ = rows;
  refresh();
}

bool InspectorSection::isNews()
{
  const auto before = std::exchange(reported_, editor_.history().state());
  const Rows rowsBefore = std::exchange(reportedRows_, rows_);
  return before != reported_ || rowsBefore != reportedRows_;
}

void InspectorSection::change(const QString& name, const Change& change)
{
  try {
    changeConstraints(editor_, name, Rows(rows_), change);
  } catch (const InputError& error) {
    Q_EMIT refused(QString::fromStdString(error.reason()));
    refresh();
  }
}

void InspectorSection::addRow(const QString& title, QWidget* field)
{
  auto* line = new QWidget(this);
  auto* label = new QLabel(title);
  label->setBuddy(field);
  newLayout<QHBoxLayout>(line, 0, 10, {label, field})->setStretch(1, 1);
  lines_->addWidget(line);
  if (title.isNull())
    label->hide();
  else
    titles_.push_back(label);
}

QLabel* InspectorSection::addText(const QString& title, const QString& name)
{
  QLabel* label = newText(name);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  addRow(title, label);
  return label;
}

VectorEdit* InspectorSection::addVector(const QString& title, const QString& name, const QString& spoken)
{
  auto* edit = named(new VectorEdit(name, spoken.isEmpty() ? QString(title).remove('&') : spoken, this), name);
  connect(edit, &VectorEdit::refused, this, &InspectorSection::refused);
  connect(edit, &VectorEdit::righted, this, &InspectorSection::righted);
  addRow(title, edit);
  return edit;
}

NumberEdit* InspectorSection::addNumber(const QString& title, const QString& name)
{
  auto* edit = named(new NumberEdit(this), name, QString(title).remove('&'));
  connect(edit, &NumberEdit::refused, this, &InspectorSection::refused);
  connect(edit, &NumberEdit::righted, this, &InspectorSection::righted);
  addRow(title, edit);
  return edit;
}

QString InspectorSection::editName(const QString& pattern, const QStringList& words) const
{
  if (!pattern.contains("%2")) return pattern.arg(subject());
  return words.size() == 1 ? pattern.arg(subject(), words[0]) : pattern.arg(subject(), words[0], words[1]);
}

void InspectorSection::explain(QWidget* field, const QString& text)
{
  titleOf(field).setToolTip(text);
  field->setToolTip(text);
  field->setAccessibleDescription(text);
}

int InspectorSection::titleWidth() const
{
  int widest = 0;
  for (const QLabel* title : titles_) widest = std::max(widest, title->sizeHint().width());
  return widest;
}

Index wholeNumber(double typed, double least, const std::string& reason)
{
  // Doubles represent all whole numbers up to here.
  constexpr double kMost = 9e15;
  if (typed < least || std::abs(typed) > kMost || typed != std::floor(typed))
    throw InputError({}, exactText(typed).toStdString() + ' ' + reason);
  return static_cast<Index>(typed);
}

}  // namespace holdfast
