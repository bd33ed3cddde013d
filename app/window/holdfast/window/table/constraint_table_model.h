#pragma once
/// Offers the constraints of an editor as rows of a table, in the order of precedence.

#include <QAbstractTableModel>
#include <memory>
#include <optional>

#include <holdfast/window/model/constraint_actions.h>
#include <holdfast/window/model/editor.h>

namespace holdfast {

/// The model reads all that it shows from the editor on demand. 10,000 rows cost no more than the few that are visible.
class ConstraintTableModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { On, Name, Kind, Where, Distance, X, Y, Z, Residual, Force, Status, ColumnCount };

  explicit ConstraintTableModel(Editor& editor, QObject* parent = nullptr);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override
  {
    return parent.isValid() ? 0 : static_cast<int>(ColumnCount);
  }
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

  /// Sets the same cell of several rows by one edit. The cell is the switch (`Qt::CheckStateRole`), a coordinate of the
  /// target (text), or the name (of the first row only). If the value is invalid, it emits `refused` and returns false.
  bool setCells(const Rows& rows, int column, const QVariant& value, int role);

  [[nodiscard]] Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
  [[nodiscard]] QStringList mimeTypes() const override;
  [[nodiscard]] QMimeData* mimeData(const QModelIndexList& indexes) const override;
  [[nodiscard]] bool canDropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                                     const QModelIndex& parent) const override;
  bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                    const QModelIndex& parent) override;

  /// Tells whether the rows are those of `Editor::list`. They differ for a moment while the editor reports a change.
  [[nodiscard]] bool isInStep() const { return shown_ == (editor_.isOpen() ? editor_.history().state() : nullptr); }

  /// Tells whether rows are sorted by numbers in this column. The numbers of the status are ranks, the gravest first.
  /// Other columns are sorted by texts.
  [[nodiscard]] bool hasNumbers(int column) const { return column == On || column >= Distance; }
  [[nodiscard]] std::optional<double> number(int row, int column) const;
  [[nodiscard]] QString text(int row, int column) const;
  [[nodiscard]] std::optional<ConstraintStatus> status(int row) const { return editor_.status(constraint(row), row); }

 Q_SIGNALS:
  void refused(const QString& reason);
  /// The model has taken what was typed, even if it is what was there before.
  void righted();

 private:
  [[nodiscard]] const Constraint& constraint(int row) const { return shown_->list.constraints[row]; }
  [[nodiscard]] const ConstraintOutcome* outcome(int row) const { return editor_.outcome(constraint(row).name, row); }
  [[nodiscard]] std::optional<double> coordinate(int row, int column) const;
  [[nodiscard]] std::optional<double> exactNumber(int row, int column) const;
  [[nodiscard]] QString residualText(const ConstraintOutcome& outcome) const;
  [[nodiscard]] QString toolTip(int row, int column) const;
  bool setCoordinate(const Rows& rows, int column, const QString& typed);
  bool rename(Index row, const QString& name);
  void follow();
  void resultsChanged();

  Editor& editor_;
  std::shared_ptr<const DocumentState> shown_;  // the rows that views know
  std::optional<Index> marked_;                 // under the cursor of the picture
};

}  // namespace holdfast
