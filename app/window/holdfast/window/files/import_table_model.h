#pragma once
/// \file
/// The constraints of a file, and which of them are to be taken in, as a table.

#include <QAbstractTableModel>
#include <filesystem>
#include <vector>

#include <holdfast/document/point_list_import.h>

namespace holdfast {

/// The constraints of a file, and what they would be in a document.
struct ImportContents {
  ConstraintList list;
  ImportPreview preview;
  std::vector<std::string> newNames;  ///< one for each constraint of the list: what the document will call it
};

/// Reads a constraint file or a point list, and finds its places in the document with the list `present`, on any
/// thread. Throws as `readConstraints` does. O(n (log n + log T)).
[[nodiscard]] ImportContents readImport(const std::filesystem::path& path, const ConstraintList& present,
                                        const Model& model);

/// `present`, followed by the constraints at `rows` of the contents with their new names.
[[nodiscard]] ConstraintList withImported(const ConstraintList& present, const ImportContents& contents,
                                          const std::vector<Index>& rows);

/// One row for each constraint of the file, in its order. Points farther from the surface than the tolerance are
/// highlighted, and left out unless the user ticks them.
class ImportTableModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Name, Kind, Place, Target, Distance, Where, ColumnCount };

  /// What rows are sorted by: numbers of distances, texts of the others.
  static constexpr int kSortRole = Qt::UserRole;

  using QAbstractTableModel::QAbstractTableModel;

  void setContents(ImportContents contents, double tolerance);
  [[nodiscard]] const ImportContents& contents() const noexcept { return contents_; }
  /// Ticks and unticks by the distance alone: what the user has ticked before is forgotten.
  void setTolerance(double tolerance);
  void tickAll(Qt::CheckState state);

  /// Places in the list, ascending.
  [[nodiscard]] std::vector<Index> tickedRows() const;
  [[nodiscard]] Index farPoints() const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 Q_SIGNALS:
  void ticksChanged();

 private:
  enum class Digits { Few, All };

  [[nodiscard]] const Constraint& constraint(int row) const { return contents_.list.constraints[row]; }
  [[nodiscard]] const ImportedPoint* pointAt(int row) const;
  [[nodiscard]] bool isFar(int row) const;
  [[nodiscard]] QString text(int row, int column, Digits digits) const;
  [[nodiscard]] QString toolTip(int row, int column) const;

  ImportContents contents_;
  std::vector<Index> pointOfRow_;  // places in the preview's points; -1 for what is no `near` point
  std::vector<bool> isTicked_;
  double tolerance_ = 0;
};

}  // namespace holdfast
