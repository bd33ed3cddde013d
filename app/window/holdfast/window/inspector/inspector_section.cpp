#include "holdfast/window/inspector/inspector_section.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <algorithm>
#include <utility>

#include <holdfast/base/error.h>
#include <holdfast/window/controls/labels.h>

namespace holdfast {

InspectorSection::InspectorSection(Editor& editor, QWidget* parent)
    : QWidget(parent), editor_(editor), form_(new QFormLayout(this))
{
  form_->setContentsMargins(0, 0, 0, 0);
  form_->setHorizontalSpacing(10);
  form_->setVerticalSpacing(6);
  form_->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
  form_->setLabelAlignment(Qt::AlignLeft);
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

QLabel* InspectorSection::addText(const QString& title, const QString& name)
{
  QLabel* label = newText(name);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  // All the room there is: by itself it would take a few words' width, and break lines that need not be broken.
  QSizePolicy policy = label->sizePolicy();
  policy.setHorizontalPolicy(QSizePolicy::Expanding);
  label->setSizePolicy(policy);
  form_->addRow(title, label);
  return label;
}

VectorEdit* InspectorSection::addVector(const QString& title, const QString& name, const QString& spoken)
{
  VectorEdit* edit = new VectorEdit(name, spoken.isEmpty() ? QString(title).remove('&') : spoken, this);
  edit->setObjectName(name);
  connect(edit, &VectorEdit::refused, this, &InspectorSection::refused);
  form_->addRow(title, edit);
  return edit;
}

NumberEdit* InspectorSection::addNumber(const QString& title, const QString& name)
{
  NumberEdit* edit = new NumberEdit(this);
  edit->setObjectName(name);
  edit->setAccessibleName(QString(title).remove('&'));
  connect(edit, &NumberEdit::refused, this, &InspectorSection::refused);
  form_->addRow(title, edit);
  return edit;
}

QComboBox* InspectorSection::addChoice(const QString& title, const QString& name, const QString& spoken,
                                       const QStringList& choices)
{
  QComboBox* box = new QComboBox(this);
  box->setObjectName(name);
  box->setAccessibleName(spoken);
  box->addItems(choices);
  form_->addRow(title, box);
  return box;
}

void InspectorSection::explain(QWidget* field, const QString& text)
{
  form_->labelForField(field)->setToolTip(text);
  field->setToolTip(text);
  field->setAccessibleDescription(text);
}

void InspectorSection::collectRows()
{
  for (int row = static_cast<int>(fields_.size()); row < form_->rowCount(); ++row) {
    QLayoutItem* title = form_->itemAt(row, QFormLayout::LabelRole);
    QLayoutItem* field = form_->itemAt(row, QFormLayout::FieldRole);
    if (field == nullptr) field = form_->itemAt(row, QFormLayout::SpanningRole);
    fields_.push_back({title == nullptr ? nullptr : title->widget(), field->widget()});
  }
}

// A form keeps the spacing of hidden rows, so what is hidden is taken out of it.
void InspectorSection::setFieldVisible(QWidget* field, bool isVisible)
{
  if (form_->rowCount() > static_cast<int>(fields_.size())) collectRows();
  const bool isShown = form_->indexOf(field) >= 0 && !field->isHidden();
  if (isShown == isVisible) return;
  for (Field& other : fields_) {
    if (other.field != field) continue;
    field->setVisible(isVisible);
    if (other.title != nullptr) other.title->setVisible(isVisible);
  }
  while (form_->rowCount() > 0) form_->takeRow(0);
  for (const Field& other : fields_) {
    if (other.field->isHidden()) continue;
    if (other.title != nullptr)
      form_->addRow(other.title, other.field);
    else
      form_->addRow(other.field);
  }
}

int InspectorSection::titleWidth()
{
  collectRows();
  int widest = 0;
  for (const Field& field : fields_)
    if (field.title != nullptr) widest = std::max(widest, field.title->sizeHint().width());
  return widest;
}

void InspectorSection::setTitleWidth(int width)
{
  collectRows();
  for (const Field& field : fields_)
    if (field.title != nullptr) field.title->setMinimumWidth(width);
}

QString axisText(int axis)
{
  return QStringLiteral("xyz").mid(axis, 1);
}

}  // namespace holdfast
