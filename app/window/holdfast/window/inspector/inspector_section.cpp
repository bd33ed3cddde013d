#include "holdfast/window/inspector/inspector_section.h"

#include <QComboBox>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include <holdfast/base/error.h>
#include <holdfast/window/controls/panel_parts.h>

namespace holdfast {

InspectorSection::InspectorSection(Editor& editor) : editor_(editor), lines_(new QVBoxLayout(this))
{
  lines_->setContentsMargins(0, 0, 0, 0);
  lines_->setSpacing(6);
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

void InspectorSection::hideEvent(QHideEvent* event)
{
  reported_.reset();
  QWidget::hideEvent(event);
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
  auto* layout = new QHBoxLayout(line);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(10);
  auto* label = new QLabel(title, line);
  label->setBuddy(field);
  layout->addWidget(label);
  layout->addWidget(field, 1);
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
  addRow(title, edit);
  return edit;
}

NumberEdit* InspectorSection::addNumber(const QString& title, const QString& name)
{
  auto* edit = named(new NumberEdit(this), name, QString(title).remove('&'));
  connect(edit, &NumberEdit::refused, this, &InspectorSection::refused);
  addRow(title, edit);
  return edit;
}

QComboBox* InspectorSection::addChoice(const QString& title, const QString& name, const QString& spoken,
                                       const QStringList& choices, const std::function<void(int)>& choose)
{
  auto* box = named(new QComboBox(this), name, spoken);
  box->addItems(choices);
  connect(box, qOverload<int>(&QComboBox::activated), this, choose);
  addRow(title, box);
  return box;
}

QLabel& InspectorSection::titleOf(QWidget* field)
{
  return *static_cast<QLabel*>(field->parentWidget()->layout()->itemAt(0)->widget());
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

void InspectorSection::setTitleWidth(int width)
{
  for (QLabel* title : titles_) title->setMinimumWidth(width);
}

QString axisText(int axis)
{
  return QStringLiteral("xyz").mid(axis, 1);
}

}  // namespace holdfast
