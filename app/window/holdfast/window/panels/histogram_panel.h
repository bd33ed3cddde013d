#pragma once
/// The panel of distributions: how well constraints are met, and how much the surface turns.

#include <QLabel>
#include <vector>

#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/model/editor.h>
#include <holdfast/window/panels/histogram_view.h>

namespace holdfast {

/// Residuals of constraints as shares of the bounding box's diagonal, on a logarithmic scale with the promise marked,
/// and rotation angles of vertices. A click on a bar picks what it counts.
class HistogramPanel : public RefreshedPanel {
  Q_OBJECT

 public:
  explicit HistogramPanel(Editor& editor);

  [[nodiscard]] HistogramView& residualView() const { return *residuals_.view; }
  [[nodiscard]] HistogramView& angleView() const { return *angles_.view; }

 Q_SIGNALS:
  void constraintsPicked(std::vector<Index> constraints);  ///< places in the editor's list, ascending
  void verticesPicked(std::vector<Index> vertices);        ///< of the file, ascending

 private:
  struct Page {
    HintedContent* content = nullptr;
    QLabel* title = nullptr;
    HistogramView* view = nullptr;
    std::vector<double> values;
  };

  [[nodiscard]] Page makePage(const QString& name);
  void refresh() override;
  void refreshResiduals();
  void refreshAngles();
  void pickConstraints(Index bar);

  Editor& editor_;
  Page residuals_;  // of each constraint of the deformed list, shares of the diagonal
  Page angles_;     // of each vertex of the file, degrees
};

}  // namespace holdfast
