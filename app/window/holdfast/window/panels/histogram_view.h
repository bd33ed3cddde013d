#pragma once
/// \file
/// A bar chart of one histogram. What the pointer is over is told, and a click tells which bar.

#include <QString>
#include <QWidget>
#include <functional>
#include <optional>

#include <vtkNew.h>

#include <holdfast/widgets/color/histogram.h>

class QLabel;
class QVTKOpenGLNativeWidget;
class vtkChartXY;
class vtkContextView;

namespace holdfast {

class RenderRequest;
struct PictureColors;

/// What a chart shows beside its bars.
struct ChartTexts {
  QString title;
  QString valueAxis;
  QString countAxis;
  std::function<QString(Index bin)> describe;  ///< the range and the count of a bar, for its tool tip
};

/// The whole column of a bar is its target: small bars are as easy to hit as large ones. Arrow keys go from bar to bar,
/// Enter is a click.
class HistogramView : public QWidget {
  Q_OBJECT

 public:
  explicit HistogramView(QWidget* parent = nullptr);
  ~HistogramView() override;

  /// `marked`: a value with a dashed line at it.
  void setHistogram(const Histogram& histogram, const ChartTexts& texts, std::optional<double> marked);

  /// Draws an example that nobody sees: `MainWindow::warmUp`. The chart is empty afterwards.
  void warmUp();

  [[nodiscard]] const Histogram& histogram() const noexcept { return histogram_; }
  /// The bar at a place in the chart (Qt's coordinates of `chartView`); none where there is no column or an empty one.
  [[nodiscard]] std::optional<Index> barAt(const QPointF& place) const;
  /// The middle of a bar's column, in the same coordinates.
  [[nodiscard]] QPointF middleOf(Index bar) const;
  [[nodiscard]] QWidget* chartView() const;

 Q_SIGNALS:
  void barClicked(Index bar);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void rebuild();
  void addBars(const PictureColors& colors);
  void addMark(const PictureColors& colors);
  void setAxes(const PictureColors& colors);
  void handleRelease(const QMouseEvent& event);
  bool handleKey(int key);
  [[nodiscard]] std::optional<Index> nextBar(Index step) const;
  void hover(std::optional<Index> bar);

  Histogram histogram_;
  ChartTexts texts_;
  std::optional<double> marked_;
  std::optional<Index> hovered_;
  QLabel* title_ = nullptr;
  QVTKOpenGLNativeWidget* view_ = nullptr;
  RenderRequest* drawing_ = nullptr;
  vtkNew<vtkContextView> context_;
  vtkNew<vtkChartXY> chart_;
};

}  // namespace holdfast
