#include "holdfast/window/panels/histogram_panel.h"

#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>
#include <limits>
#include <unordered_set>

#include <holdfast/deform/deform_details.h>
#include <holdfast/geometry/rotation_log.h>
#include <holdfast/widgets/rotation_sphere/rotation_projection.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

// Powers of ten of the scale of residuals: below the first there is only rounding, and the promise is inside.
constexpr int kFirstPower = -17;
constexpr int kLastPower = -11;

constexpr Index kMostAngleBins = 25;

std::vector<double> residualShares(const DeformResult& deformation, double diagonal)
{
  std::vector<double> shares;
  for (const ConstraintOutcome& outcome : deformation.report.constraints)
    shares.push_back(outcome.residual ? *outcome.residual / diagonal : kNoValue);
  return shares;
}

Index countWithinLimits(const std::vector<ConstraintOutcome>& outcomes)
{
  return std::count_if(outcomes.begin(), outcomes.end(), [](const ConstraintOutcome& outcome) {
    return outcome.residual && *outcome.residual <= outcome.limit;
  });
}

std::vector<double> anglesOf(const Model& model, const DeformResult& deformation)
{
  const SolverMesh& mesh = model.solverMesh;
  std::vector<double> ofUnknowns;
  for (Index u = 0; u < mesh.unknownCount(); ++u)
    ofUnknowns.push_back(mesh.componentOf[u] < 0 ? kNoValue : angleDegrees(deformation.rotations.row(u).transpose()));
  std::vector<double> angles;
  for (const Index unknown : mesh.weld.unknownOf) angles.push_back(ofUnknowns[unknown]);
  return angles;
}

}  // namespace

HistogramPanel::HistogramPanel(Editor& editor) : editor_(editor)
{
  setObjectName("histogramPanel");
  auto* splitter = new QSplitter(Qt::Vertical, this);
  splitter->setChildrenCollapsible(false);
  residuals_ = makePage("residuals");
  angles_ = makePage("angles");
  splitter->addWidget(residuals_.content);
  splitter->addWidget(angles_.content);
  fill(*this, splitter);
  connect(residuals_.view, &HistogramView::barClicked, this, &HistogramPanel::pickConstraints);
  connect(angles_.view, &HistogramView::barClicked, this,
          [this](Index bar) { Q_EMIT verticesPicked(placesInBin(angles_.view->histogram(), angles_.values, bar)); });
  connect(&editor_, &Editor::opened, this, &HistogramPanel::refresh);
  connect(&editor_, &Editor::deformed, this, &HistogramPanel::refresh);
}

HistogramPanel::Page HistogramPanel::makePage(const QString& name)
{
  Page page;
  page.title = newText(name + "Title");
  page.title->setContentsMargins(6, 2, 6, 2);
  page.view = named(new HistogramView, name + "View");
  auto* chart = new QWidget;
  newLayout<QVBoxLayout>(chart, 0, 2, {page.title, page.view})->setStretch(1, 1);
  page.content = new HintedContent(chart, name + "Hint");
  return page;
}

void HistogramPanel::refresh()
{
  if (!isVisible()) return;
  residuals_.values.clear();
  angles_.values.clear();
  if (editor_.deformation()) {
    refreshResiduals();
    refreshAngles();
  }
  const auto showPage = [&](const Page& page, const QString& hint) {
    if (!page.values.empty()) return page.content->showContent();
    page.content->showHint(editor_.isOpen() ? hint : tr("No mesh is open."));
  };
  showPage(residuals_, tr("No residuals yet: add a constraint."));
  showPage(angles_, tr("No rotation yet: give a handle a turn."));
}

void HistogramPanel::refreshResiduals()
{
  const DeformResult& deformation = *editor_.deformation();
  const double diagonal = editor_.model()->solverMesh.diagonal;
  std::vector<double> shares = residualShares(deformation, diagonal);
  const Histogram histogram = logarithmicHistogram(shares, kFirstPower, kLastPower);
  if (histogram.valueCount == 0) return;
  const double promise = std::ranges::min(deformation.details->diagnosis.limits) / diagonal;
  ChartTexts texts;
  texts.title = tr("Residuals of constraints: %1 of %2 within their limits, the least %3 of the diagonal (dashed)")
                    .arg(countWithinLimits(deformation.report.constraints))
                    .arg(histogram.valueCount)
                    .arg(roundedText(promise));
  texts.valueAxis = tr("residual / diagonal of the bounding box");
  texts.countAxis = tr("constraints");
  const QString units = QString::fromStdString(editor_.deformedState()->list.units);
  texts.describe = [=](Index bar) {
    const double low = histogram.edges[bar];
    const double high = histogram.edges[bar + 1];
    return tr("%1 to %2 of the diagonal (%3 to %4 %5)\nconstraints: %6")
        .arg(roundedText(low), roundedText(high), roundedText(low * diagonal), roundedText(high * diagonal), units)
        .arg(histogram.counts[bar]);
  };
  residuals_.values = std::move(shares);
  residuals_.title->setText(texts.title);
  residuals_.view->setHistogram(histogram, texts, promise);
}

void HistogramPanel::refreshAngles()
{
  const DeformResult& deformation = *editor_.deformation();
  if (!hasRotation(boundaryRotations(deformation))) return;
  angles_.values = anglesOf(*editor_.model(), deformation);
  const Histogram histogram = linearHistogram(angles_.values, TickSteps::Degrees, kMostAngleBins);
  ChartTexts texts;
  texts.title = tr("Rotation angles of vertices");
  texts.valueAxis = tr("angle, degrees (whole turns counted)");
  texts.countAxis = tr("vertices");
  texts.describe = [=](Index bar) {
    return tr("%1° to %2°\nvertices: %3")
        .arg(roundedText(histogram.edges[bar]), roundedText(histogram.edges[bar + 1]))
        .arg(histogram.counts[bar]);
  };
  angles_.title->setText(texts.title);
  angles_.view->setHistogram(histogram, texts, std::nullopt);
}

void HistogramPanel::pickConstraints(Index bar)
{
  // What is shown may be older than the list: constraints are found by their names.
  std::unordered_set<std::string> names;
  for (const Index k : placesInBin(residuals_.view->histogram(), residuals_.values, bar))
    names.insert(editor_.deformation()->report.constraints[k].name);
  const std::vector<Constraint>& list = editor_.list().constraints;
  std::vector<Index> places;
  for (std::size_t k = 0; k < list.size(); ++k)
    if (names.count(list[k].name) > 0) places.push_back(static_cast<Index>(k));
  Q_EMIT constraintsPicked(places);
}

}  // namespace holdfast
