#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <holdfast/widgets/color/coloring.h>
#include <holdfast/window/controls/command_tree.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/model/background_job.h>
#include <holdfast/window/model/field_value.h>
#include <holdfast/window/panels/panels.h>
#include <holdfast/window/text/color_text.h>
#include <holdfast/window/text/constraint_text.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

enum MeasuredColumn { MeasuredWhat, MeasuredNow, MeasuredAtRest, MeasuredDifference, MeasuredColumnCount };

/// Lists what is under the cursor, probes and rulers, each with its numbers now and at rest.
class MeasuredPanel final : public RefreshedPanel {
 public:
  explicit MeasuredPanel(Editor& editor) : editor_(editor)
  {
    setObjectName("measuredPanel");
    tree_ = named(new CommandTree, "measuredTree", tr("Measurements"));
    tree_->setColumnCount(MeasuredColumnCount);
    tree_->setHeaderLabels({tr("Measured"), tr("Now"), tr("At rest"), tr("Difference")});
    tree_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    tree_->header()->setSectionResizeMode(MeasuredWhat, QHeaderView::Stretch);
    tree_->addCommand(tr("&Copy"), "measuredCopy", tr("Copies the table, for a spreadsheet"), QKeySequence::Copy,
                      [this] { copy(); });
    tree_->addCommand(tr("&Remove"), "measuredRemove", tr("Removes the selected measurements"), QKeySequence::Delete,
                      [this] { removeSelected(); });
    pages_ = new HintedContent(tree_, "measuredHint");
    fill(*this, pages_);
    connect(&editor, &Editor::opened, this, &MeasuredPanel::begin);
    for (const auto& signal : {&Editor::deformed, &Editor::annotationsChanged, &Editor::decimalsChanged})
      connect(&editor, signal, this, &MeasuredPanel::refresh);
    connect(&editor, &Editor::underCursorChanged, this, [this] {
      if (isVisible() && tree_->topLevelItemCount() > 0) fillCursor();
    });
    refresh();
  }

 private:
  struct ShownField {
    QString name;
    Coloring coloring;
    ValueMeaning meaning;
  };

  void begin()
  {
    computing_.cancel();
    fieldsOf_.reset();
    fields_.clear();
    tree_->clear();
    refresh();
  }

  void refresh() override
  {
    if (!isVisible()) return;
    if (!editor_.isOpen()) return pages_->showHint(tr("No mesh is open."));
    pages_->showContent();
    if (editor_.deformation() && fieldsOf_ != editor_.deformation() && !computing_.isRunning()) computeFields();
    const auto& [probes, rulers] = editor_.measurements();
    const int count = static_cast<int>(1 + probes.size() + rulers.size());
    while (tree_->topLevelItemCount() > count) delete tree_->takeTopLevelItem(count);
    while (tree_->topLevelItemCount() < count) {
      auto* item = new QTreeWidgetItem(tree_);
      item->setExpanded(true);
    }
    fillCursor();
    int row = 1;
    for (std::size_t k = 0; k < probes.size(); ++k)
      fillProbe(*tree_->topLevelItem(row++), tr("Probe %1").arg(k + 1), probes[k]);
    for (std::size_t k = 0; k < rulers.size(); ++k)
      fillRuler(*tree_->topLevelItem(row++), tr("Ruler %1").arg(k + 1), rulers[k]);
  }

  void computeFields()
  {
    computing_.start([this, model = editor_.model(), deformation = editor_.deformation(),
                      shaded = editor_.mesh().contents->mesh().shaded(),
                      units = editor_.list().units](Progress&) -> BackgroundJob::Finish {
      std::vector<ShownField> fields;
      for (std::size_t k = 1; k < colorByNames().size(); ++k) {
        const auto field = static_cast<ColorBy>(k);
        const auto coloring = coloringOf(*model, *deformation, ColorSettings{field}, units, shaded.get());
        fields.push_back({QString::fromStdString(coloring->scale.title).replace('\n', ' '),
                          *coloring,
                          {field, coloring->scale.promise}});
      }
      return [this, deformation, fields = std::move(fields)] {
        fieldsOf_ = deformation;
        fields_ = fields;
        refresh();
      };
    });
  }

  [[nodiscard]] Vector3 placeOf(const SurfaceLocation& location, const Positions& positions) const
  {
    return positionOf(pointOf(location, editor_.model()->mesh), positions);
  }

  static void setNumber(QTreeWidgetItem& item, int column, double value, const QString& shown)
  {
    item.setText(column, std::isnan(value) ? QString() : shown);
    item.setData(column, Qt::UserRole, std::isnan(value) ? QString() : exactText(value));
    item.setToolTip(column, item.data(column, Qt::UserRole).toString());
    item.setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  }

  static QTreeWidgetItem& child(QTreeWidgetItem& item, int row, const QString& name)
  {
    if (row >= item.childCount()) item.addChild(new QTreeWidgetItem);
    item.child(row)->setText(MeasuredWhat, name);
    item.child(row)->setToolTip(MeasuredWhat, name);
    return *item.child(row);
  }

  void setLength(QTreeWidgetItem& item, int column, double value) const
  {
    setNumber(item, column, value, numberText(value, editor_.lengthStyle()));
  }

  void fillLengths(QTreeWidgetItem& item, double now, double rest) const
  {
    setLength(item, MeasuredNow, now);
    setLength(item, MeasuredAtRest, rest);
    setLength(item, MeasuredDifference, now - rest);
  }

  void fillCursor()
  {
    const auto& pick = editor_.underCursor().pick;
    fillProbe(*tree_->topLevelItem(0), tr("Cursor"), pick ? std::optional(pick->location) : std::nullopt);
  }

  void fillProbe(QTreeWidgetItem& item, const QString& name, const std::optional<SurfaceLocation>& at)
  {
    item.setText(MeasuredWhat, at ? name + ": " + locationText(*at) : name);
    item.setToolTip(MeasuredWhat, item.text(MeasuredWhat));
    constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
    const Vector3 now = at ? placeOf(*at, editor_.positions()) : Vector3::Constant(kNothing);
    const Vector3 rest = at ? placeOf(*at, editor_.model()->mesh.positions) : now;
    for (int column = MeasuredNow; column < MeasuredColumnCount; ++column) setNumber(item, column, kNothing, {});
    int row = 0;
    for (int axis = 0; axis < 3; ++axis) fillLengths(child(item, row++, axisText(axis)), now[axis], rest[axis]);
    for (const ShownField& field : fields_) {
      const double value = at ? fieldValue(editor_, field.coloring, *at) : kNothing;
      setNumber(child(item, row++, field.name), MeasuredNow, value,
                valueText(value, field.meaning, editor_.decimals()));
    }
    if (!fields_.empty()) fillAxis(child(item, row++, tr("axis of rotation")), at);
    trim(item, row);
  }

  /// Of the deformation whose fields are shown.
  void fillAxis(QTreeWidgetItem& item, const std::optional<SurfaceLocation>& at) const
  {
    const std::optional<Vector3> axis =
        at ? rotationAxis(*editor_.model(), *fieldsOf_, pointOf(*at, editor_.model()->mesh)) : std::nullopt;
    item.setText(MeasuredNow, axis ? roundedText(*axis) : QString());
    item.setData(MeasuredNow, Qt::UserRole, axis ? exactText(*axis) : QString());
    item.setToolTip(MeasuredNow, item.data(MeasuredNow, Qt::UserRole).toString());
    item.setTextAlignment(MeasuredNow, Qt::AlignRight | Qt::AlignVCenter);
  }

  void fillRuler(QTreeWidgetItem& item, const QString& name, const std::array<SurfaceLocation, 2>& ends)
  {
    const auto vectorIn = [&](const Positions& positions) {
      return Vector3(placeOf(ends[1], positions) - placeOf(ends[0], positions));
    };
    const Vector3 now = vectorIn(editor_.positions());
    const Vector3 rest = vectorIn(editor_.model()->mesh.positions);
    item.setText(MeasuredWhat, name);
    item.setToolTip(MeasuredWhat, tr("From %1 to %2").arg(locationText(ends[0]), locationText(ends[1])));
    fillLengths(item, now.stableNorm(), rest.stableNorm());
    for (int axis = 0; axis < 3; ++axis)
      fillLengths(child(item, axis, tr("along %1").arg(axisText(axis))), now[axis], rest[axis]);
    trim(item, 3);
  }

  /// An item may have been that of another kind before.
  static void trim(QTreeWidgetItem& item, int rows)
  {
    while (item.childCount() > rows) delete item.takeChild(rows);
  }

  void removeSelected()
  {
    const Measurements& all = editor_.measurements();
    Measurements rest;
    const auto isSelected = [this](std::size_t row) {
      const QTreeWidgetItem& item = *tree_->topLevelItem(static_cast<int>(row));
      bool isAny = item.isSelected();
      for (int k = 0; k < item.childCount(); ++k) isAny = isAny || item.child(k)->isSelected();
      return isAny;
    };
    for (std::size_t k = 0; k < all.probes.size(); ++k)
      if (!isSelected(1 + k)) rest.probes.push_back(all.probes[k]);
    for (std::size_t k = 0; k < all.rulers.size(); ++k)
      if (!isSelected(1 + all.probes.size() + k)) rest.rulers.push_back(all.rulers[k]);
    if (rest.probes.size() == all.probes.size() && rest.rulers.size() == all.rulers.size()) return;
    tree_->clearSelection();
    editor_.setMeasurements(tr("remove measurements"), std::move(rest));
  }

  void copy()
  {
    QStringList lines{tr("Measured\tNow\tAt rest\tDifference")};
    const auto add = [&](const QTreeWidgetItem& item) {
      QStringList cells{item.text(MeasuredWhat)};
      for (int column = MeasuredNow; column < MeasuredColumnCount; ++column)
        cells << item.data(column, Qt::UserRole).toString();
      lines << cells.join('\t');
    };
    for (int row = 1; row < tree_->topLevelItemCount(); ++row) {
      const QTreeWidgetItem& item = *tree_->topLevelItem(row);
      add(item);
      for (int k = 0; k < item.childCount(); ++k) add(*item.child(k));
    }
    QApplication::clipboard()->setText(lines.join('\n') + '\n');
  }

  Editor& editor_;
  HintedContent* pages_ = nullptr;
  CommandTree* tree_ = nullptr;
  std::shared_ptr<const DeformResult> fieldsOf_;
  std::vector<ShownField> fields_;  // of `fieldsOf_`, which may be older than the editor's
  BackgroundJob computing_;         // last: its thread uses what is above
};

}  // namespace

QWidget* newMeasuredPanel(Editor& editor)
{
  return new MeasuredPanel(editor);
}

}  // namespace holdfast
