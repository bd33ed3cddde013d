#pragma once
/// Offers what each listed vertex of a handle has of its own as a table.

#include <QAbstractTableModel>
#include <memory>

#include <holdfast/document/history.h>

namespace holdfast {

/// The model has a row for each vertex. It keeps the state and no copy of the numbers: a handle may have a hundred
/// thousand vertices.
class VertexTableModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum class What { Rotations, Targets };
  enum Column { Vertex, X, Y, Z, Degrees };

  explicit VertexTableModel(What what, QObject* parent = nullptr) : QAbstractTableModel(parent), what_(what) {}

  /// Shows a handle of the list, which has what the table is about: one entry for each of its `VertexIds`. Targets are
  /// written with `decimals`, if there are any.
  void show(std::shared_ptr<const DocumentState> state, Index constraint, std::optional<int> decimals);

  [[nodiscard]] Index vertex(int row) const { return std::get<VertexIds>(handle().select.what).ids[row]; }
  [[nodiscard]] double number(int row, int column) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 Q_SIGNALS:
  void entered(int row, int column, double number);
  void refused(const QString& reason);
  /// A number was typed.
  void righted();

 private:
  [[nodiscard]] const HandleConstraint& handle() const;

  What what_;
  std::optional<int> decimals_;
  std::shared_ptr<const DocumentState> state_;
  Index constraint_ = 0;
};

}  // namespace holdfast
