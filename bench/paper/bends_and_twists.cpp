// Rotation methods side by side on bends and twists of a bar from 30 to 360 degrees.

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "bench/paper/charts.h"
#include "bench/paper/experiments.h"
#include "bench/paper/rotation_methods.h"

namespace holdfast::paper {
namespace {

constexpr int kStep = 30;  // degrees
constexpr int kLast = 360;

/// A motion by any angle.
struct Sweep {
  const char* name;
  SurveyTask (*task)(double degrees);
};
constexpr Sweep kBending{"bend", bentBar};
constexpr Sweep kTwisting{"twist", twistedBar};

struct Measure {
  const char* name;
  const char* label;
  Scale scale;
  double (*of)(const RotationOutcome&);
};

const std::vector<Measure>& measures()
{
  static const std::vector<Measure> kAll{
      {"edges", "edges, RMS of relative change", Scale::Log, [](const RotationOutcome& o) { return o.edges; }},
      {"volume", "volume, relative change", Scale::Log, [](const RotationOutcome& o) { return std::abs(o.volume); }},
      {"dihedral", "angles between normals, RMS of change, degrees", Scale::Linear,
       [](const RotationOutcome& o) { return o.dihedral.rms; }},
      {"seconds", "seconds from mesh to result", Scale::Log, [](const RotationOutcome& o) { return o.seconds; }}};
  return kAll;
}

/// What a method makes of a sweep.
struct SweptMethod {
  std::string name;
  std::vector<RotationOutcome> outcomes;  ///< by angle
};

std::vector<SweptMethod> sweptBy(const std::vector<RotationMethod>& methods, const Sweep& sweep)
{
  Motion motion;
  for (int degrees = kStep; degrees <= kLast; degrees += kStep) motion.push_back(sweep.task(degrees));
  std::vector<SweptMethod> swept;
  for (const RotationMethod& method : methods) swept.push_back({method.name, method.run(motion, kFoundChange)});
  return swept;
}

int degreesAt(std::size_t step)
{
  return kStep * static_cast<int>(step + 1);
}

std::vector<Curve> curvesOf(const std::vector<SweptMethod>& swept, const Measure& measure)
{
  std::vector<Curve> curves;
  for (const SweptMethod& method : swept) {
    curves.push_back({method.name, {}});
    for (std::size_t k = 0; k < method.outcomes.size(); ++k)
      curves.back().points.emplace_back(degreesAt(k), measure.of(method.outcomes[k]));
  }
  return curves;
}

void noteNumbers(Section& section, const Sweep& sweep, const std::vector<SweptMethod>& swept)
{
  for (const SweptMethod& method : swept)
    for (std::size_t k = 0; k < method.outcomes.size(); ++k)
      for (const Measure& measure : measures())
        section.numbers[fmt::format("{} {} {} {}", sweep.name, degreesAt(k), method.name, measure.name)] =
            measure.of(method.outcomes[k]);
}

std::string sweepCell(const RotationOutcome& outcome)
{
  return fmt::format("{:.3f}, {:.2f}, {:.1f}, {:.2f}{}", outcome.edges, outcome.volume, outcome.dihedral.rms,
                     outcome.seconds, outcome.isConverged ? "" : " *");
}

Table tableOf(const Sweep& sweep, const std::vector<SweptMethod>& swept)
{
  Table table{{fmt::format("{}, degrees", sweep.name)}, {}};
  for (const SweptMethod& method : swept) table.columns.push_back(method.name);
  for (std::size_t k = 0; k < swept.front().outcomes.size(); ++k) {
    table.rows.push_back({fmt::format("{}", degreesAt(k))});
    for (const SweptMethod& method : swept) table.rows.back().push_back(sweepCell(method.outcomes[k]));
  }
  return table;
}

void addSweep(Section& section, const Workbench& bench, const Sweep& sweep, const std::vector<RotationMethod>& methods)
{
  const std::vector<SweptMethod> swept = sweptBy(methods, sweep);
  noteNumbers(section, sweep, swept);
  section.tables.push_back(tableOf(sweep, swept));
  for (const Measure& measure : measures()) {
    const std::string file = fmt::format("rotations_{}_{}.svg", sweep.name, measure.name);
    writeFile(bench.picture(file), curveChart(fmt::format("Bar, {}", sweep.name), {"degrees", Scale::Linear},
                                              {measure.label, measure.scale}, curvesOf(swept, measure)));
    section.pictures.push_back({file, fmt::format("{} of a bar: {}", sweep.name, measure.label), true});
  }
}

/// Of the number of two methods over all angles of a sweep.
std::pair<double, double> leastAndLargestRatio(const Section& section, const Sweep& sweep, const std::string& above,
                                               const std::string& below)
{
  std::vector<double> ratios;
  for (int degrees = kStep; degrees <= kLast; degrees += kStep)
    ratios.push_back(section.numbers.at(fmt::format("{} {} {}", sweep.name, degrees, above)) /
                     section.numbers.at(fmt::format("{} {} {}", sweep.name, degrees, below)));
  const auto [least, largest] = std::ranges::minmax(ratios);
  return {least, largest};
}

std::string resultOf(const Section& section)
{
  const auto at = [&](const char* name) { return section.numbers.at(name); };
  const auto edges = leastAndLargestRatio(section, kBending, "found edges", "ORIGINAL_ARAP edges");
  return fmt::format(
      "A bend by 180 degrees changes edges by {:.3f} without rotations, by {:.3f} with given ones and by {:.3f} with "
      "found ones. ORIGINAL_ARAP, which has the energy of found rotations, comes to the same shapes: at every bend "
      "ours changes edges {:.3f} to {:.3f} times as much. SRE_ARAP is near our smooth ones, {:.3f} and {:.3f} at 180 "
      "degrees. A twist by 300 degrees takes {:.0f} % of the volume with given rotations, {:.0f} % with found ones, "
      "{:.0f} % with smooth ones and {:.0f} % with ORIGINAL_ARAP. At a full twist the handle is where it is at rest. "
      "Methods that find rotations may lose the turn there: edges change by {:.3f} with ORIGINAL_ARAP and by {:.3f} "
      "with our smooth rotations, by {:.3f} with given ones, which cannot.",
      at("bend 180 none edges"), at("bend 180 given edges"), at("bend 180 found edges"), edges.first, edges.second,
      at("bend 180 SRE_ARAP edges"), at("bend 180 found-smooth edges"), 100 * at("twist 300 given volume"),
      100 * at("twist 300 found volume"), 100 * at("twist 300 found-smooth volume"),
      100 * at("twist 300 ORIGINAL_ARAP volume"), at("twist 360 ORIGINAL_ARAP edges"),
      at("twist 360 found-smooth edges"), at("twist 360 given edges"));
}

}  // namespace

Section bendsAndTwists(const Workbench& bench)
{
  Section section;
  section.paper =
      "rotations that handles give, carried into the surface by the rotation field, (25) to (29). It has none that "
      "are found.";
  section.method = fmt::format(
      "a bar of 10 x 10 x 90 units, one end held, the other one bent along an arc that keeps the length of its "
      "middle line, or twisted. A cell has the root of the mean square of relative changes of edges, the relative "
      "change of the volume, the root of the mean square of changes of angles between neighbouring normals, in "
      "degrees, and seconds. All methods that iterate end where no vertex moves by more than {:g} of the diagonal (* "
      "where they do not). Ours start from the rest shape at every angle, which a handle states. CGAL {} knows the "
      "places of the handle alone, which are the same after a full turn. So its three methods follow the handle in "
      "steps of {} degrees, each from the shape of the one before, as in a drag, and have the seconds of all steps "
      "so far.",
      kFoundChange, cgalVersion(), kStep);
  const std::vector<RotationMethod> methods = allRotationMethods();
  for (const Sweep& sweep : {kBending, kTwisting}) addSweep(section, bench, sweep, methods);
  section.result = resultOf(section);
  return section;
}

}  // namespace holdfast::paper
