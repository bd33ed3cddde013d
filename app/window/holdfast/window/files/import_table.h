#pragma once
/// Previews an import: what a file has, and what of it is ticked.

#include <QAbstractTableModel>
#include <vector>

#include <holdfast/window/files/import_contents.h>

namespace holdfast {

/// The table has one row for each constraint or point of the file, in the order of the file.
class ImportTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Name, Kind, Place, Goal, Distance, Where };

  /// The role of the values by which rows are sorted. Distances are sorted as numbers, other columns as texts.
  static constexpr int kSortRole = Qt::UserRole;

  [[nodiscard]] const ImportContents& contents() const { return contents_; }

  /// Shows other contents, and ticks what has no fault and lies within the tolerance. The tolerance is a length in the
  /// units of the mesh.
  void setContents(ImportContents contents, double tolerance);

  /// Sets the tolerance, and ticks and unticks by the distance alone. What the user has ticked before is forgotten.
  void setTolerance(double tolerance);

  /// Ticks or unticks all rows that can be read, including far ones and those with a fault.
  void tickAll(bool isTicked);

  /// Returns the ticked constraints as places in the list.
  [[nodiscard]] std::vector<Index> tickedConstraints() const;
  [[nodiscard]] Index faultyRows() const;
  /// Counts the points that are farther from the surface than the tolerance.
  [[nodiscard]] Index farPoints() const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 private:
  [[nodiscard]] bool isReadable(int row) const { return contents_.rows[row].constraint.has_value(); }
  [[nodiscard]] const Constraint& constraint(int row) const;
  [[nodiscard]] const ImportedPoint* point(int row) const;
  [[nodiscard]] bool isFar(int row) const { return point(row) != nullptr && point(row)->distance > tolerance_; }
  [[nodiscard]] bool isMarked(int row) const { return isFar(row) || !contents_.rows[row].fault.isEmpty(); }
  void tickNear(double tolerance);
  void reportChange();
  [[nodiscard]] QString text(int row, int column, bool isExact = false) const;
  [[nodiscard]] QString toolTip(int row, int column) const;

  ImportContents contents_;
  std::vector<const ImportedPoint*> points_;  // of the list; null for what is no `near` point
  std::vector<bool> isTicked_;
  double tolerance_ = 0;
};

}  // namespace holdfast
