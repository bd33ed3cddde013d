#include "holdfast/window/viewport/view_state.h"

#include <QSettings>
#include <algorithm>
#include <array>
#include <string_view>

#include <holdfast/window/viewport/viewport.h>

namespace holdfast {
namespace {

// In the order of the enumerators.
constexpr std::array<std::string_view, 6> kMapNames{
    "blue-green-yellow", "blue-grey-yellow", "blue-white-orange", "grey", "blue-white-red", "black-red-yellow"};
constexpr std::array<std::string_view, 3> kRestNames{"hidden", "edges", "surface"};
constexpr std::array<std::string_view, 3> kEdgeNames{"sharp", "all", "none"};
constexpr std::array<std::string_view, 3> kSurfaceNames{"shaded", "wireframe", "points"};

constexpr std::array<std::string_view, 3> kLegendNames{"right", "left", "hidden"};

constexpr std::array<std::string_view, 2> kAxisNames{"y", "z"};

constexpr std::string_view kLogarithmic = "log";

// Doubles have no more powers of ten.
constexpr Index kMostDecades = 600;

template <class Names, class Value>
std::string nameOf(const Names& names, Value value)
{
  return std::string(names[static_cast<std::size_t>(value)]);
}

/// The enumerator called `name`; `otherwise` where there is none.
template <class Names, class Value>
Value valueNamed(const Names& names, const std::optional<std::string>& name, Value otherwise)
{
  if (!name) return otherwise;
  const auto found = std::find(names.begin(), names.end(), *name);
  return found == names.end() ? otherwise : static_cast<Value>(found - names.begin());
}

/// None where the field chooses, and for names of other versions.
std::optional<ColorMap> mapNamed(const std::optional<std::string>& name)
{
  const auto found = std::find(kMapNames.begin(), kMapNames.end(), name);
  return found == kMapNames.end() ? std::nullopt : std::optional(static_cast<ColorMap>(found - kMapNames.begin()));
}

QString upAxisSetting(const LoadedMesh& mesh)
{
  return "upAxis/" + QString::fromStdString(mesh.path.extension().string()).toLower();
}

/// The default where `state` says nothing, or more than there is.
LogarithmicRange logarithmicRange(const ViewState& state)
{
  const Index decades = state.decades.value_or(LogarithmicRange{}.decades);
  return decades <= kMostDecades ? LogarithmicRange{static_cast<int>(decades)} : LogarithmicRange{};
}

}  // namespace

ViewState viewStateOf(Viewport& viewport)
{
  const ColorSettings& colors = viewport.colors();
  const DisplaySettings& display = viewport.display();
  ViewState state;
  state.camera = cameraOf(*viewport.renderer().GetActiveCamera());
  state.upAxis = nameOf(kAxisNames, viewport.upAxis());
  state.colorBy = nameOf(colorByNames(), colors.field);
  if (const auto* fixed = std::get_if<FixedRange>(&colors.range)) state.range = {fixed->low, fixed->high};
  if (const auto* logarithmic = std::get_if<LogarithmicRange>(&colors.range)) {
    state.scale = kLogarithmic;
    state.decades = logarithmic->decades;
  }
  if (colors.map) state.colorMap = nameOf(kMapNames, *colors.map);
  if (colors.bands > 0) state.bands = colors.bands;
  if (display.legend != LegendSide::Right) state.legend = nameOf(kLegendNames, display.legend);
  state.decimals = viewport.editor().decimals();
  state.restShape = nameOf(kRestNames, display.rest);
  state.meshEdges = nameOf(kEdgeNames, display.edges);
  state.surface = nameOf(kSurfaceNames, display.surface);
  state.showsConstraints = display.areConstraintsShown;
  state.showsRotations = display.rotations == RotationDisplay::Arrows;
  if (viewport.hidden()) state.hiddenFaces = viewport.hiddenFaces();
  return state;
}

void apply(const ViewState& state, Viewport& viewport)
{
  ColorSettings colors = viewport.colors();
  colors.field = valueNamed(colorByNames(), state.colorBy, colors.field);
  if (state.colorBy || state.colorMap) colors.map = mapNamed(state.colorMap);
  if (state.colorBy) colors.bands = static_cast<int>(std::min<Index>(state.bands.value_or(0), kMostBands));
  if (state.range)
    colors.range = FixedRange{(*state.range)[0], (*state.range)[1]};
  else if (state.scale == kLogarithmic)
    colors.range = logarithmicRange(state);
  else if (state.colorBy)
    colors.range = AutomaticRange{};
  viewport.setColors(colors);

  DisplaySettings display = viewport.display();
  display.rest = valueNamed(kRestNames, state.restShape, display.rest);
  display.edges = valueNamed(kEdgeNames, state.meshEdges, display.edges);
  display.surface = valueNamed(kSurfaceNames, state.surface, display.surface);
  display.areConstraintsShown = state.showsConstraints.value_or(display.areConstraintsShown);
  if (state.showsRotations)
    display.rotations = *state.showsRotations ? RotationDisplay::Arrows : RotationDisplay::Hidden;
  if (state.colorBy) display.legend = valueNamed(kLegendNames, state.legend, LegendSide::Right);
  viewport.setDisplay(display);
  // A view that names no field is that of a mesh: lengths stay as they are written.
  if (state.colorBy || state.decimals) viewport.editor().setDecimals(state.decimals);
  if (state.hiddenFaces) viewport.hideFaces(*state.hiddenFaces);

  viewport.setUpAxis(valueNamed(kAxisNames, state.upAxis, viewport.upAxis()));
  if (state.camera) viewport.setCamera(*state.camera);
}

UpAxis upAxisOf(const LoadedMesh& mesh)
{
  const QVariant chosen = QSettings().value(upAxisSetting(mesh));
  if (chosen.isValid()) return static_cast<UpAxis>(chosen.toInt());
  return mesh.isScan && !upAxisSetting(mesh).endsWith(".stl") ? UpAxis::Y : UpAxis::Z;
}

void rememberUpAxis(const LoadedMesh& mesh, UpAxis axis)
{
  QSettings().setValue(upAxisSetting(mesh), static_cast<int>(axis));
}

}  // namespace holdfast
