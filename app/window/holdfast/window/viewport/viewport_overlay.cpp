#include "holdfast/window/viewport/viewport_overlay.h"

#include <QFontMetricsF>
#include <QLineF>
#include <QMarginsF>
#include <QPainter>
#include <cmath>
#include <utility>

#include <vtkPropCollection.h>

#include <holdfast/deform/outcomes.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfaceRulerRepresentation.h>
#include <holdfast/widgets/marks/constraint_glyphs.h>
#include <holdfast/window/controls/theme.h>
#include <holdfast/window/model/field_value.h>
#include <holdfast/window/text/color_text.h>
#include <holdfast/window/text/constraint_text.h>
#include <holdfast/window/text/number_text.h>
#include <holdfast/window/viewport/label_place.h>
#include <holdfast/window/viewport/tool.h>
#include <holdfast/window/viewport/viewport.h>

namespace holdfast {
namespace {

constexpr double kNoteMargin = 14;
constexpr QMarginsF kNotePadding(8, 5, 8, 5);

constexpr double kProbeRadius = 5;
constexpr QPointF kProbeLabelOffset(7, 0);
constexpr double kRulerGap = 4;
// A share of the way from the eye: parts of the surface that touch a place do not hide it.
constexpr double kHidden = 1 - 1e-6;

bool isRotation(ColorBy field)
{
  return field == ColorBy::Rotation || field == ColorBy::Angle;
}

/// Returns the ruler's text with the decimals of the document.
QString rulerText(vtkHoldfastSurfaceRulerRepresentation& ruler, const LengthStyle& style)
{
  if (!style.decimals) return toText(ruler.GetLabel());
  const Vector3 vector = ruler.GetVector();
  const QString along =
      QString(": %1, %2, %3")
          .arg(numberText(vector.x(), style), numberText(vector.y(), style), numberText(vector.z(), style));
  return lengthText(ruler.GetDistance(), style) + (ruler.GetShowVector() ? along : QString()) +
         ViewportOverlay::tr(" (rest %1)").arg(lengthText(ruler.GetRestDistance(), {{}, style.decimals}));
}

/// `plate` above the middle of a line, or beside it where the line is upright.
QRectF besideLine(QRectF plate, const QPointF& a, const QPointF& b)
{
  const QLineF line = a.x() < b.x() ? QLineF(a, b) : QLineF(b, a);
  QLineF away = line.normalVector().unitVector();
  if (line.length() == 0) away = QLineF(0, 0, 0, -1);
  const double half = (std::abs(away.dx()) * plate.width() + std::abs(away.dy()) * plate.height()) / 2;
  plate.moveCenter(line.center() + (half + kRulerGap) * QPointF(away.dx(), away.dy()));
  return plate;
}

// A shorter wait needs no number, and in a drag no word.
constexpr double kSecondsUnsaid = 0.5;
constexpr int kMillisecondsBetweenTimes = 200;

}  // namespace

QString solveStateText(const Editor& editor)
{
  switch (editor.solveState()) {
    case SolveState::Nothing:
    case SolveState::Current:
      break;
    case SolveState::Solving: {
      const bool isLong = editor.secondsOlder() >= kSecondsUnsaid;
      // A drag's frames follow one another faster than a word can be read.
      if (editor.deformation() && editor.history().isInGesture() && !isLong) return {};
      const QString text = editor.deformation() ? ViewportOverlay::tr("Older than the constraints: solving")
                                                : ViewportOverlay::tr("At rest: solving");
      return isLong ? ViewportOverlay::tr("%1, %2 s").arg(text).arg(editor.secondsOlder(), 0, 'f', 1) : text;
    }
    case SolveState::Cancelled:
      return ViewportOverlay::tr("Older than the constraints: solving was stopped. F5 solves again.");
    case SolveState::Unusable:
      return ViewportOverlay::tr("Older than the constraints: they cannot be solved.") + '\n' + editor.error();
  }
  return {};
}

ViewportOverlay::ViewportOverlay(Editor& editor, Viewport& viewport)
    : QWidget(&viewport), editor_(editor), viewport_(viewport)
{
  setObjectName("overlay");
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  connect(&editor_, &Editor::opened, this, qOverload<>(&QWidget::update));
  connect(&editor_, &Editor::solveStateChanged, this, &ViewportOverlay::followState);
  clock_.setInterval(kMillisecondsBetweenTimes);
  connect(&clock_, &QTimer::timeout, this, &ViewportOverlay::followState);
  connect(&editor_, &Editor::solveStateChanged, &clock_,
          [this] { editor_.solveState() == SolveState::Solving ? clock_.start() : clock_.stop(); });
  for (const auto& signal : {&Editor::annotationsChanged, &Editor::decimalsChanged})
    connect(&editor_, signal, this, qOverload<>(&QWidget::update));
  connect(&editor_, &Editor::decimalsChanged, this, &ViewportOverlay::followPicture);
  connect(&viewport_, &Viewport::hiddenChanged, this, &ViewportOverlay::followState);
  connect(&viewport_, &Viewport::rendered, this, &ViewportOverlay::followPicture);
  connect(&editor_, &Editor::underCursorChanged, this, &ViewportOverlay::followCursor);
}

void ViewportOverlay::setTools(std::vector<const Tool*> tools)
{
  tools_ = std::move(tools);
  update();
}

void ViewportOverlay::paintEvent(QPaintEvent* /*event*/)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (!editor_.isOpen()) return;
  paint(legend(), painter, rect(), palette());
  paintState(painter);
  paintProbes(painter);
  for (const auto& [place, text] : rulerLabels_) paintNote(painter, place, text);
  paintCursor(painter);
  for (const Tool* tool : tools_) {
    if (tool == nullptr) continue;
    painter.save();
    tool->paint(painter);
    painter.restore();
  }
}

LegendContent ViewportOverlay::legend() const
{
  LegendContent legend;
  legend.side = viewport_.display().legend;
  const ColorBy field = viewport_.colors().field;
  const auto& deformation = editor_.deformation();
  if (const auto& coloring = viewport_.coloring())
    legend.scale = coloring->scale;
  else if (deformation && field != ColorBy::None)
    legend.line = tr("%1: nothing to show").arg(fieldText(field).name);
  if (!deformation || !viewport_.display().areConstraintsShown) return legend;
  for (const ConstraintStatus status :
       {ConstraintStatus::Disabled, ConstraintStatus::Missed, ConstraintStatus::Conflicting,
        ConstraintStatus::Redundant, ConstraintStatus::Met})
    if (const Index count = countOf(deformation->report, status); count > 0) legend.counts.emplace_back(status, count);
  return legend;
}

QString ViewportOverlay::stateText() const
{
  QString text = solveStateText(editor_);
  if (const double share = viewport_.shownShare(); share != 1) {
    if (!text.isEmpty()) text += '\n';
    text += share == 0 ? tr("At rest") : tr("%1 % of the way from rest").arg(std::lround(100 * share));
  }
  if (viewport_.hidden()) text += (text.isEmpty() ? "" : "\n") + tr("Faces are hidden. Ctrl+Shift+H shows them.");
  return text;
}

void ViewportOverlay::paintState(QPainter& painter) const
{
  const QString text = stateText();
  if (text.isEmpty()) return;
  const QRectF available(0, 0, width() - 4 * kNoteMargin, height());
  QRectF box = painter.fontMetrics().boundingRect(available.toRect(), Qt::AlignLeft | Qt::TextWordWrap, text);
  box.moveTo(kNoteMargin + 8, kNoteMargin + 5);
  paintNote(painter, box, text);
}

void ViewportOverlay::paintNote(QPainter& painter, const QRectF& text, const QString& words) const
{
  QColor plate = palette().color(QPalette::Window);
  plate.setAlpha(225);
  painter.setPen(Qt::NoPen);
  painter.setBrush(plate);
  painter.drawRoundedRect(text + kNotePadding, 4, 4);
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(text, Qt::AlignLeft | Qt::TextWordWrap, words);
}

QString ViewportOverlay::cursorText() const
{
  const auto& [pick, constraint] = editor_.underCursor();
  if (!pick || !editor_.isOpen()) return {};
  const SurfacePoint point = pointOf(pick->location, editor_.model()->mesh);
  QStringList lines{locationText(pick->location) + labelText(editor_.model()->mesh, pick->location),
                    placeText(positionOf(point, viewport_.surface()->positions()), editor_.lengthStyle())};
  if (const auto& coloring = viewport_.coloring())
    lines << QString::fromStdString(coloring->scale.title).replace('\n', ' ') + ": " +
                 valueAtPlace(*coloring, pick->location);
  const auto& state = editor_.deformedState();
  if (constraint && state && *constraint < static_cast<Index>(state->list.constraints.size())) {
    const Constraint& found = state->list.constraints[*constraint];
    lines << quoted(found.name) + ": " + statusText(editor_.status(found, *constraint));
  }
  return lines.join('\n');
}

/// Of a field of rotations with the axis.
QString ViewportOverlay::valueAtPlace(const Coloring& coloring, const SurfaceLocation& location) const
{
  const ColorBy field = viewport_.colors().field;
  QString text =
      valueText(fieldValue(editor_, coloring, location), {field, coloring.scale.promise}, editor_.decimals());
  if (!isRotation(field) || editor_.deformation() == nullptr) return text;
  const SurfacePoint point = pointOf(location, editor_.model()->mesh);
  if (const auto axis = rotationAxis(*editor_.model(), *editor_.deformation(), point))
    text += tr(" about %1").arg(roundedText(*axis));
  return text;
}

QRectF ViewportOverlay::cursorNote() const
{
  const QString text = cursorText();
  if (text.isEmpty()) return {};
  QRectF box = QFontMetricsF(font()).boundingRect(QRectF(0, 0, width() / 2.0, height()), Qt::AlignLeft, text);
  box.moveBottomLeft({kNoteMargin + 8, height() - kNoteMargin - 5});
  return box;
}

void ViewportOverlay::followState()
{
  if (std::exchange(stateText_, stateText()) != stateText_) update();
}

void ViewportOverlay::followLegend()
{
  const LegendContent before = std::exchange(legend_, legend());
  if (before == legend_) return;
  for (const LegendContent* some : {&before, &std::as_const(legend_)})
    update(boxOf(*some, font(), rect()).toAlignedRect());
}

void ViewportOverlay::followCursor()
{
  const QRectF before = std::exchange(cursorNote_, cursorNote());
  if (before.isEmpty() && cursorNote_.isEmpty()) return;
  update(((before | cursorNote_) + kNotePadding).toAlignedRect());
}

void ViewportOverlay::followPicture()
{
  if (editor_.isOpen() && !editor_.measurements().probes.empty()) update();
  followCursor();
  const RulerLabels before = std::exchange(rulerLabels_, currentRulerLabels());
  if (before == rulerLabels_) return;
  for (const RulerLabels* labels : {&before, &std::as_const(rulerLabels_)})
    for (const auto& [place, text] : *labels) update((place + kNotePadding).toAlignedRect());
}

ViewportOverlay::RulerLabels ViewportOverlay::currentRulerLabels() const
{
  RulerLabels labels;
  std::vector<QRectF> taken{viewport_.legendBox()};
  const DisplayTransform display(viewport_.renderer());
  vtkPropCollection& props = *viewport_.widgetRenderer().GetViewProps();
  for (int k = 0; k < props.GetNumberOfItems(); ++k) {
    auto* ruler = vtkHoldfastSurfaceRulerRepresentation::SafeDownCast(props.GetItemAsObject(k));
    if (ruler == nullptr || ruler->GetVisibility() == 0 || !ruler->IsPlaced()) continue;
    const auto a = toDisplay(display, ruler->GetHandle(0).GetPlace());
    const auto b = toDisplay(display, ruler->GetHandle(1).GetPlace());
    if (!a || !b) continue;
    const QString text = rulerText(*ruler, editor_.lengthStyle());
    const QRectF plate = besideLine(plateOf(text), viewport_.toPlace(*a), viewport_.toPlace(*b));
    taken.push_back(movedClear(plate, rect(), taken));
    labels.emplace_back(taken.back() - kNotePadding, text);
  }
  return labels;
}

QRectF ViewportOverlay::plateOf(const QString& text) const
{
  return QFontMetricsF(font()).boundingRect(rect(), Qt::AlignLeft, text) + kNotePadding;
}

std::vector<ViewportOverlay::ShownProbe> ViewportOverlay::shownProbes() const
{
  std::vector<ShownProbe> shown;
  const auto& probes = editor_.measurements().probes;
  if (probes.empty()) return shown;
  std::vector<QRectF> taken{viewport_.legendBox()};
  for (const auto& [box, text] : rulerLabels_) taken.push_back(box + kNotePadding);
  const DisplayTransform display(viewport_.renderer());
  for (std::size_t k = 0; k < probes.size(); ++k) {
    const SurfacePoint point = pointOf(probes[k], editor_.model()->mesh);
    const Vector3 place = positionOf(point, viewport_.surface()->positions());
    const auto pixel = toDisplay(display, place);
    if (!pixel || !viewport_.surface()->isKept(place)) continue;
    const auto hit = viewport_.surface()->firstHit(display.rayTo(place));
    ShownProbe probe{viewport_.toPlace(*pixel), hit && hit->t < kHidden, {}, QString::number(k + 1)};
    if (!rect().contains(probe.place.toPoint())) continue;
    if (const auto& coloring = viewport_.coloring())
      if (!std::isnan(fieldValue(editor_, *coloring, probes[k])))
        probe.text += ": " + valueAtPlace(*coloring, probes[k]);
    QRectF plate = plateOf(probe.text);
    plate.moveBottomLeft(probe.place + kProbeLabelOffset);
    taken.push_back(movedClear(plate, rect(), taken));
    probe.label = taken.back() - kNotePadding;
    shown.push_back(std::move(probe));
  }
  return shown;
}

/// A ring and the label; faint where the surface hides the place.
void ViewportOverlay::paintProbes(QPainter& painter) const
{
  for (const ShownProbe& probe : shownProbes()) {
    painter.setOpacity(probe.isBehind ? 0.4 : 1);
    painter.setBrush(Qt::NoBrush);
    for (const auto& [color, width] : {std::pair(QColor(Qt::white), 4.0), std::pair(toQColor(kAccentColor), 2.0)}) {
      painter.setPen(QPen(color, width));
      painter.drawEllipse(probe.place, kProbeRadius, kProbeRadius);
    }
    paintNote(painter, probe.label, probe.text);
  }
  painter.setOpacity(1);
}

void ViewportOverlay::paintCursor(QPainter& painter) const
{
  if (const QString text = cursorText(); !text.isEmpty()) paintNote(painter, cursorNote(), text);
}

}  // namespace holdfast
