#pragma once
/// A panel of distributions. It shows how well constraints are met, and how much the surface turns.

#include <functional>
#include <optional>
#include <vector>

#include <holdfast/widgets/color/histogram.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/model/editor.h>

namespace holdfast {

struct ChartTexts {
  QString title;
  QString valueAxis;
  QString countAxis;
  std::function<QString(Index bin)> describe;  ///< the range and the count of a bar, for its tool tip
};

/// The view draws a histogram. A bar answers to the mouse in its whole column. Arrow keys go from bar to bar, and Enter
/// acts as a click.
class HistogramView : public QWidget {
  Q_OBJECT

 public:
  explicit HistogramView(QWidget* parent = nullptr);

  /// Shows a histogram. A dashed line is drawn at the value `marked`.
  void setHistogram(const Histogram& histogram, const ChartTexts& texts, std::optional<double> marked);
  [[nodiscard]] const Histogram& histogram() const noexcept { return histogram_; }

  /// Returns the bar whose column is at `place`; none beside the columns and for an empty bar.
  [[nodiscard]] std::optional<Index> barAt(const QPointF& place) const;
  [[nodiscard]] QPointF middleOf(Index bar) const;

 Q_SIGNALS:
  void barClicked(Index bar);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* /*event*/) override { hover(std::nullopt); }

 private:
  [[nodiscard]] Index barCount() const { return static_cast<Index>(histogram_.counts.size()); }
  [[nodiscard]] Index largestCount() const;
  [[nodiscard]] QRectF plot() const;
  [[nodiscard]] std::optional<Index> nextBar(Index step) const;
  void hover(std::optional<Index> bar);

  Histogram histogram_;
  ChartTexts texts_;
  std::optional<double> marked_;
  std::optional<Index> hovered_;
};

/// The panel shows two histograms. One has the residuals of constraints as shares of the bounding box's diagonal. Its
/// scale is logarithmic, and the promise is marked. The other has the rotation angles of vertices. A click on a bar
/// picks what it counts.
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
