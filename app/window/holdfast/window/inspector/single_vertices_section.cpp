#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <algorithm>

#include <holdfast/constraints/handle_validation.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/inspector/sections.h>
#include <holdfast/window/model/handle_actions.h>
#include <holdfast/window/table/vertex_table_model.h>
#include <holdfast/window/text/constraint_text.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

constexpr int kMostRowsInSight = 6;

/// Why the vertices cannot have entries of their own; empty if they can.
QString whyNotSingle(HandleConstraint handle)
{
  const auto* listed = std::get_if<VertexIds>(&handle.select.what);
  if (listed == nullptr)
    return InspectorSection::tr(
               "Only a handle that lists its vertices can give each its own. This one selects by its shape: %1.")
        .arg(selectionText(handle.select));
  handle.motion = std::monostate{};
  handle.rotations.assign(listed->ids.size(), {});
  const auto error = validateHandle(handle);
  return error ? QString::fromStdString(error->reason) : QString();
}

QTableView* newVertexTable(VertexTableModel& model, const QString& name, const QString& spoken)
{
  auto* table = named(new QTableView, name, spoken);
  table->setModel(&model);
  setTableLook(*table);
  table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table->verticalHeader()->hide();
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  return table;
}

int heightOfRows(const QTableView& table)
{
  const int rows = std::min(table.model()->rowCount(), kMostRowsInSight);
  return table.horizontalHeader()->sizeHint().height() + rows * table.verticalHeader()->defaultSectionSize() +
         2 * table.frameWidth();
}

class SingleVerticesSection : public SectionOf<HandleConstraint> {
 public:
  explicit SingleVerticesSection(Editor& editor) : SectionOf(editor)
  {
    reason_ = newText("singleVerticesReason");
    addRow({}, reason_);
    rotations_ = addPart(VertexTableModel::What::Rotations, tr("&Rotations"), "vertexRotations");
    targets_ = addPart(VertexTableModel::What::Targets, tr("Tar&gets"), "vertexTargets");
    connect(rotations_.button, &QPushButton::clicked, this, &SingleVerticesSection::switchRotations);
    connect(targets_.button, &QPushButton::clicked, this, &SingleVerticesSection::switchTargets);
    connect(rotations_.model, &VertexTableModel::entered, this, &SingleVerticesSection::setRotation);
    connect(targets_.model, &VertexTableModel::entered, this, &SingleVerticesSection::setTarget);
  }

 private:
  void refresh() override
  {
    setVisible(rows().size() == 1);
    if (rows().size() != 1 || !isNews()) return;
    // A drag selects no other vertices, and there may be many.
    if (!editor().history().isInGesture()) reason_->setText(whyNotSingle(what()));
    const QString reason = reason_->text();
    setFieldVisible(reason_, !reason.isEmpty());
    showPart(rotations_, !what().rotations.empty(), reason);
    showPart(targets_, std::holds_alternative<VertexTargets>(what().motion), reason);
  }

  /// The switch, and the table that is visible while it is on.
  struct Part {
    QPushButton* button = nullptr;
    QTableView* table = nullptr;
    VertexTableModel* model = nullptr;
  };

  Part addPart(VertexTableModel::What what, const QString& title, const QString& name)
  {
    const QString spoken = QString(title).remove('&');
    Part part;
    part.model = new VertexTableModel(what, this);
    part.button = named(new QPushButton, name + "Switch");
    addRow(title, part.button);
    part.table = newVertexTable(*part.model, name, tr("%1 of single vertices").arg(spoken));
    addRow({}, part.table);
    connect(part.model, &VertexTableModel::refused, this, &InspectorSection::refused);
    return part;
  }

  void showPart(const Part& part, bool isOwn, const QString& reason)
  {
    setFieldVisible(part.button, reason.isEmpty());
    setFieldVisible(part.table, isOwn);
    part.button->setText(isOwn ? tr("Take One for All") : tr("Give Each Vertex Its Own"));
    if (!isOwn) return;
    part.model->show(editor().history().state(), rows().front());
    part.table->setFixedHeight(heightOfRows(*part.table));
  }

  void setRotation(int row, int column, double number)
  {
    const QString vertex = QString::number(rotations_.model->vertex(row));
    edit(tr("turn vertex %1 of %2 otherwise").arg(vertex, subject()), [&](HandleConstraint& handle) {
      AxisAngle& turn = handle.rotations[row];
      (column == VertexTableModel::Degrees ? turn.degrees : turn.axis[column - VertexTableModel::X]) = number;
      requireAxis(turn.axis);
      return true;
    });
  }

  void setTarget(int row, int column, double number)
  {
    const QString vertex = QString::number(targets_.model->vertex(row));
    const int axis = column - VertexTableModel::X;
    edit(tr("move vertex %1 of %2 to %3 = %4").arg(vertex, subject(), axisText(axis), exactText(number)),
         [&](HandleConstraint& handle) {
           std::get<VertexTargets>(handle.motion).places[row][axis] = number;
           return true;
         });
  }

  void switchRotations()
  {
    const bool isOwn = !what().rotations.empty();
    const QString name =
        isOwn ? tr("take one rotation for all vertices of %1") : tr("give each vertex of %1 its own rotation");
    change(name.arg(subject()), [&](Constraint constraint) {
      if (!isOwn) return restated(editor(), constraint, withRotations);
      std::get<HandleConstraint>(constraint.what).rotations.clear();
      return constraint;
    });
  }

  void switchTargets()
  {
    const bool isOwn = std::holds_alternative<VertexTargets>(what().motion);
    const QString name =
        isOwn ? tr("take one motion for all vertices of %1") : tr("give each vertex of %1 its own target");
    change(name.arg(subject()),
           [&](const Constraint& constraint) { return restated(editor(), constraint, isOwn ? byFrames : byTargets); });
  }

  QLabel* reason_ = nullptr;
  Part rotations_;
  Part targets_;
};

}  // namespace

InspectorSection* newSingleVerticesSection(Editor& editor)
{
  return new SingleVerticesSection(editor);
}

}  // namespace holdfast
