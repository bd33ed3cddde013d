// Fig. 12: what set-up and decomposition cost with soft and with hard constraints, from the benchmark's own figures.

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench/paper/charts.h"
#include "bench/paper/experiments.h"

namespace holdfast::paper {
namespace {

/// Counters "row/column" of the benchmark.
using Counters = std::map<std::string, double>;

Counters countersOf(const std::string& file)
{
  const nlohmann::json measured = nlohmann::json::parse(readFile(file));
  Counters counters;
  for (const auto& [name, value] : measured.at("benchmarks").at(0).items())
    if (value.is_number()) counters[name] = value.get<double>();
  return counters;
}

/// Measures a generated mesh of so many thousand vertices.
Counters measured(Section& section, const Workbench& bench, const std::string& thousands)
{
  const std::string file = bench.out("figure_12_" + thousands + "k.json");
  section.commands.push_back(bench.run({HOLDFAST_BENCH, thousands, "--benchmark_filter=^hard",
                                        "--benchmark_out=" + file, "--benchmark_out_format=json"}));
  return countersOf(file);
}

std::string thousandth(double value)
{
  return fmt::format("{:.3f}", value);
}

void addRows(Section& section, const std::string& mesh, const Counters& counters)
{
  const auto addRow = [&](const std::string& step, const std::string& unit) {
    const double soft = counters.at(step + "/" + unit + " soft");
    const double hard = counters.at(step + "/" + unit + " hard");
    section.numbers[mesh + "k " + step] = hard / soft;
    section.tables[0].rows.push_back(
        {mesh + ",000", step + ", " + unit, thousandth(soft), thousandth(hard), fmt::format("{:.2f}", hard / soft)});
  };
  for (const char* step : {"set-up", "decomposition", "set-up and decomposition", "solution"}) addRow(step, "s");
  addRow("factor", "MiB");
}

std::string rangeOfRatios(Section& section, const std::vector<std::string>& thousands)
{
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
  for (const std::string& mesh : thousands) {
    least = std::min(least, section.numbers[mesh + "k set-up and decomposition"]);
    most = std::max(most, section.numbers[mesh + "k set-up and decomposition"]);
  }
  return fmt::format("Hard constraints take {:.2f} to {:.2f} times as long as soft ones.", least, most);
}

}  // namespace

Section costsOfMeshes(const Workbench& bench, const std::vector<std::string>& thousands)
{
  Section section;
  section.paper = "set-up and decomposition take about as long with hard constraints as with soft ones.";
  section.method =
      "the benchmark on generated meshes: one end fixed, the other moved, and 300 points each on vertices, on edges "
      "and in faces. Medians over turns; both take turns in one process.";
  section.tables = {{{"vertices", "step", "soft", "hard", "hard / soft"}, {}}};
  std::vector<Bar> bars;
  for (const std::string& mesh : thousands) {
    const Counters counters = measured(section, bench, mesh);
    for (const char* kind : {"soft", "hard"})
      bars.push_back(
          {mesh + ",000, " + kind,
           {counters.at(fmt::format("set-up/s {}", kind)), counters.at(fmt::format("decomposition/s {}", kind))}});
    addRows(section, mesh, counters);
  }
  section.result = rangeOfRatios(section, thousands);
  writeFile(bench.picture("figure_12.svg"),
            barChart("Set-up and decomposition", "s", {"set-up", "decomposition"}, bars));
  section.pictures = {{"figure_12.svg", "Set-up and decomposition, soft and hard", true}};
  return section;
}

Section hardAgainstSoft(const Workbench& bench)
{
  return costsOfMeshes(bench, {"35", "173", "438"});
}

}  // namespace holdfast::paper
