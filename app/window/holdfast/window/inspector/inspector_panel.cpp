#include "holdfast/window/inspector/inspector_panel.h"

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <set>

#include <holdfast/base/error.h>
#include <holdfast/window/controls/labels.h>
#include <holdfast/window/controls/status_style.h>
#include <holdfast/window/inspector/frame_section.h>
#include <holdfast/window/inspector/outcome_section.h>
#include <holdfast/window/inspector/point_section.h>
#include <holdfast/window/inspector/region_sections.h>
#include <holdfast/window/inspector/single_vertices_section.h>
#include <holdfast/window/text/constraint_text.h>

namespace holdfast {

InspectorPanel::InspectorPanel(Editor& editor, QWidget* parent) : QWidget(parent), editor_(editor)
{
  setObjectName("inspectorPanel");
  empty_ = newHint("inspectorEmpty");

  QWidget* content = new QWidget;
  QVBoxLayout* layout = new QVBoxLayout(content);
  layout->setContentsMargins(10, 10, 10, 10);
  layout->setSpacing(6);
  makeHead(*layout);
  addSection(*layout, tr("Place"), new LocationSection(editor));
  addSection(*layout, tr("Target"), new TargetSection(editor));
  addSection(*layout, tr("Vertices"), new VerticesSection(editor));
  addSection(*layout, tr("Motion"), new HandleSection(editor));
  addSection(*layout, tr("Frames"), new FrameSection(editor));
  addSection(*layout, tr("Single vertices"), new SingleVerticesSection(editor));
  addSection(*layout, tr("Places"), new RelativeSection(editor));
  addSection(*layout, tr("Outcome"), new OutcomeSection(editor));
  layout->addStretch(1);
  int widest = 0;
  for (const Part& part : parts_) widest = std::max(widest, part.section->titleWidth());
  for (const Part& part : parts_) part.section->setTitleWidth(widest);

  QScrollArea* area = new QScrollArea;
  area->setAccessibleName(tr("Selected constraints"));
  area->setWidget(content);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  pages_ = new QStackedWidget;
  pages_->addWidget(empty_);
  pages_->addWidget(area);
  QVBoxLayout* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  outer->addWidget(pages_);

  for (const auto signal : {&Editor::opened, &Editor::deformed, &Editor::solveStateChanged})
    connect(&editor, signal, this, &InspectorPanel::refresh);
  for (const auto signal : {&Editor::stateChanged, &Editor::constraintSelectionChanged})
    connect(&editor, signal, this, [this] {
      reason_->setVisible(false);
      refresh();
    });
  refresh();
}

void InspectorPanel::makeHead(QVBoxLayout& layout)
{
  kind_ = new QLabel;
  kind_->setObjectName("inspectorKind");
  name_ = new QLineEdit;
  name_->setObjectName("inspectorName");
  name_->setAccessibleName(tr("Name of the constraint"));
  enabled_ = new QCheckBox(tr("&Enabled"));
  enabled_->setObjectName("inspectorEnabled");
  reason_ = new QLabel;
  reason_->setObjectName("inspectorRefusal");
  reason_->setWordWrap(true);
  reason_->setVisible(false);
  layout.addWidget(kind_);
  layout.addWidget(name_);
  layout.addWidget(enabled_);
  layout.addWidget(reason_);
  connect(name_, &QLineEdit::editingFinished, this, &InspectorPanel::rename);
  connect(enabled_, &QCheckBox::clicked, this, &InspectorPanel::enable);
}

void InspectorPanel::addSection(QVBoxLayout& layout, const QString& title, InspectorSection* section)
{
  QLabel* label = new QLabel(title);
  QFont font = label->font();
  font.setBold(true);
  label->setFont(font);
  label->setContentsMargins(0, 8, 0, 0);
  layout.addWidget(label);
  layout.addWidget(section);
  connect(section, &InspectorSection::refused, this, &InspectorPanel::refuse);
  parts_.push_back({label, section});
}

void InspectorPanel::showEvent(QShowEvent* event)
{
  refresh();
  QWidget::showEvent(event);
}

void InspectorPanel::refresh()
{
  if (!isVisible()) return;
  const Rows& rows = editor_.selectedConstraints();
  const bool isEmpty = !editor_.isOpen() || rows.empty();
  const bool isStale = !isEmpty && rows.back() >= static_cast<Index>(editor_.list().constraints.size());
  pages_->setCurrentIndex(isEmpty || isStale ? 0 : 1);
  empty_->setText(editor_.isOpen() ? tr("Select a constraint to see and edit it.") : tr("No mesh is open."));
  if (isEmpty || isStale) return;
  refreshHead();
  for (const Part& part : parts_) {
    const bool areFit = std::all_of(rows.begin(), rows.end(),
                                    [&](Index row) { return part.section->fits(editor_.list().constraints[row]); });
    part.section->setVisible(areFit);
    if (areFit) part.section->inspect(rows);
    part.title->setVisible(!part.section->isHidden());
  }
}

void InspectorPanel::refreshHead()
{
  const Rows& rows = editor_.selectedConstraints();
  const auto& constraints = editor_.list().constraints;
  std::set<QString> kinds;
  for (const Index row : rows) kinds.insert(kindText(constraints[row]));
  QStringList words(kinds.begin(), kinds.end());
  kind_->setText(rows.size() == 1 ? words.front()
                                  : tr("%1 constraints: %2").arg(QString::number(rows.size()), words.join(", ")));
  name_->setVisible(rows.size() == 1);
  const QString name = QString::fromStdString(constraints[rows.front()].name);
  if (!(name_->isModified() && name_->hasFocus()) && name_->text() != name) name_->setText(name);
  const auto on = std::count_if(rows.begin(), rows.end(), [&](Index row) { return constraints[row].isEnabled; });
  const bool isMixed = on > 0 && on < static_cast<std::ptrdiff_t>(rows.size());
  enabled_->setCheckState(isMixed ? Qt::PartiallyChecked : on > 0 ? Qt::Checked : Qt::Unchecked);
  enabled_->setTristate(false);
}

void InspectorPanel::rename()
{
  if (!name_->isModified() || editor_.selectedConstraints().size() != 1) return;
  name_->setModified(false);
  try {
    renameConstraint(editor_, editor_.selectedConstraints().front(), name_->text());
  } catch (const InputError& error) {
    refuse(QString::fromStdString(error.reason()));
  }
  refreshHead();
}

void InspectorPanel::enable(bool isEnabled)
{
  const Rows rows = editor_.selectedConstraints();
  isEnabled ? enableConstraints(editor_, rows) : disableConstraints(editor_, rows);
  refreshHead();
}

void InspectorPanel::refuse(const QString& reason)
{
  QPalette own = palette();
  own.setColor(QPalette::WindowText, statusColor(ConstraintStatus::Conflicting, lightnessOf(own)));
  reason_->setPalette(own);
  reason_->setText(reason);
  reason_->setVisible(true);
}

}  // namespace holdfast
