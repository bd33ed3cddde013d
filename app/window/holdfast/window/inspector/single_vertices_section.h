#pragma once
/// \file
/// The inspector of what single vertices of a handle do: rotations and targets of their own.

#include <holdfast/window/inspector/inspector_section.h>
#include <holdfast/window/table/vertex_table_model.h>

class QPushButton;
class QTableView;

namespace holdfast {

/// Of one handle that lists its vertices; of others why they cannot have any.
class SingleVerticesSection : public InspectorSection {
  Q_OBJECT

 public:
  SingleVerticesSection(Editor& editor, QWidget* parent = nullptr);
  [[nodiscard]] bool fits(const Constraint& constraint) const override;

 protected:
  void refresh() override;

 private:
  /// The switch, and the table where it is on.
  struct Part {
    QPushButton* button = nullptr;
    QTableView* table = nullptr;
    VertexTableModel* model = nullptr;
  };

  [[nodiscard]] Part addPart(VertexTableModel::What what, const QString& title, const QString& name);
  void showPart(const Part& part, bool isOwn, const QString& reason);
  void setRotation(int row, int column, double number);
  void setTarget(int row, int column, double number);
  void switchRotations();
  void switchTargets();
  [[nodiscard]] const HandleConstraint& handle() const
  {
    return std::get<HandleConstraint>(constraint(rows().front()).what);
  }

  QLabel* reason_ = nullptr;
  Part rotations_;
  Part targets_;
};

}  // namespace holdfast
