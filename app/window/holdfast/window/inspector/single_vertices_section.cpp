#include "holdfast/window/inspector/single_vertices_section.h"

#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <algorithm>

#include <holdfast/constraints/handle_validation.h>
#include <holdfast/window/model/handle_actions.h>
#include <holdfast/window/text/constraint_text.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

constexpr int kMostRowsInSight = 6;

/// Why the vertices cannot have entries of their own; empty where they can.
QString whyNotSingle(HandleConstraint handle)
{
  const auto* listed = std::get_if<VertexIds>(&handle.select.what);
  if (listed == nullptr)
    return SingleVerticesSection::tr(
               "Only a handle that lists its vertices can give each its own. This one selects "
               "by its shape: %1.")
        .arg(selectionText(handle.select));
  handle.motion = std::monostate{};
  handle.rotations.assign(listed->ids.size(), {});
  const auto error = validateHandle(handle);
  return error ? QString::fromStdString(error->reason) : QString();
}

QTableView* newVertexTable(VertexTableModel& model, const QString& name, const QString& spoken)
{
  auto* table = new QTableView;
  table->setObjectName(name);
  table->setAccessibleName(spoken);
  table->setModel(&model);
  table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  table->setAlternatingRowColors(true);
  table->setShowGrid(false);
  table->setWordWrap(false);
  table->setTabKeyNavigation(false);
  table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table->verticalHeader()->hide();
  table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().height() * 3 / 2);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table->horizontalHeader()->setHighlightSections(false);
  return table;
}

int heightOfRows(const QTableView& table)
{
  const int rows = std::min(table.model()->rowCount(), kMostRowsInSight);
  return table.horizontalHeader()->sizeHint().height() + rows * table.verticalHeader()->defaultSectionSize() +
         2 * table.frameWidth();
}

}  // namespace

SingleVerticesSection::SingleVerticesSection(Editor& editor, QWidget* parent) : InspectorSection(editor, parent)
{
  reason_ = new QLabel(this);
  reason_->setObjectName("singleVerticesReason");
  reason_->setWordWrap(true);
  form().addRow(reason_);
  rotations_ = addPart(VertexTableModel::What::Rotations, tr("&Rotations"), "vertexRotations");
  targets_ = addPart(VertexTableModel::What::Targets, tr("Tar&gets"), "vertexTargets");
  connect(rotations_.button, &QPushButton::clicked, this, &SingleVerticesSection::switchRotations);
  connect(targets_.button, &QPushButton::clicked, this, &SingleVerticesSection::switchTargets);
  connect(rotations_.model, &VertexTableModel::entered, this, &SingleVerticesSection::setRotation);
  connect(targets_.model, &VertexTableModel::entered, this, &SingleVerticesSection::setTarget);
}

SingleVerticesSection::Part SingleVerticesSection::addPart(VertexTableModel::What what, const QString& title,
                                                           const QString& name)
{
  const QString spoken = QString(title).remove('&');
  Part part;
  part.model = new VertexTableModel(what, this);
  part.button = new QPushButton(this);
  part.button->setObjectName(name + "Switch");
  form().addRow(title, part.button);
  part.table = newVertexTable(*part.model, name, tr("%1 of single vertices").arg(spoken));
  form().addRow(part.table);
  connect(part.model, &VertexTableModel::refused, this, &InspectorSection::refused);
  return part;
}

bool SingleVerticesSection::fits(const Constraint& constraint) const
{
  return std::holds_alternative<HandleConstraint>(constraint.what);
}

void SingleVerticesSection::refresh()
{
  setVisible(rows().size() == 1);
  if (rows().size() != 1 || !isNews()) return;
  // A drag selects no other vertices, and there may be many.
  if (!editor().history().isInGesture()) reason_->setText(whyNotSingle(handle()));
  const QString reason = reason_->text();
  setFieldVisible(reason_, !reason.isEmpty());
  showPart(rotations_, !handle().rotations.empty(), reason);
  showPart(targets_, std::holds_alternative<VertexTargets>(handle().motion), reason);
}

void SingleVerticesSection::showPart(const Part& part, bool isOwn, const QString& reason)
{
  setFieldVisible(part.button, reason.isEmpty());
  setFieldVisible(part.table, isOwn);
  part.button->setText(isOwn ? tr("Take One for All") : tr("Give Each Vertex Its Own"));
  if (!isOwn) return;
  part.model->show(editor().history().state(), rows().front());
  part.table->setFixedHeight(heightOfRows(*part.table));
}

void SingleVerticesSection::switchRotations()
{
  const bool isOwn = !handle().rotations.empty();
  const QString name =
      isOwn ? tr("take one rotation for all vertices of %1") : tr("give each vertex of %1 its own rotation");
  change(name.arg(subject()), [&](Constraint constraint) {
    if (!isOwn) return restated(editor(), constraint, withRotations);
    std::get<HandleConstraint>(constraint.what).rotations.clear();
    return constraint;
  });
}

void SingleVerticesSection::switchTargets()
{
  const bool isOwn = std::holds_alternative<VertexTargets>(handle().motion);
  const QString name =
      isOwn ? tr("take one motion for all vertices of %1") : tr("give each vertex of %1 its own target");
  change(name.arg(subject()),
         [&](const Constraint& constraint) { return restated(editor(), constraint, isOwn ? byFrames : byTargets); });
}

void SingleVerticesSection::setRotation(int row, int column, double number)
{
  const QString vertex = QString::number(rotations_.model->vertex(row));
  change(tr("turn vertex %1 of %2 otherwise").arg(vertex, subject()), [&](Constraint constraint) {
    AxisAngle& turn = std::get<HandleConstraint>(constraint.what).rotations[row];
    (column == VertexTableModel::Degrees ? turn.degrees : turn.axis[column - VertexTableModel::X]) = number;
    requireAxis(turn.axis);
    return constraint;
  });
}

void SingleVerticesSection::setTarget(int row, int column, double number)
{
  const QString vertex = QString::number(targets_.model->vertex(row));
  const int axis = column - VertexTableModel::X;
  change(tr("move vertex %1 of %2 to %3 = %4").arg(vertex, subject(), axisText(axis), exactText(number)),
         [&](Constraint constraint) {
           std::get<VertexTargets>(std::get<HandleConstraint>(constraint.what).motion).places[row][axis] = number;
           return constraint;
         });
}

}  // namespace holdfast
