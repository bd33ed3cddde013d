// What the paper leaves for later: causes of instability taken apart, and what each cure does against each of them.

#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include "bench/paper/causes.h"
#include "bench/paper/experiments.h"

namespace holdfast::paper {
namespace {

struct CauseView {
  const char* caption;
  std::function<std::string(const CauseOutcome&)> cell;
};

std::string lossText(const Outcome& outcome)
{
  if (!outcome.isSolved()) return "**fails**";
  return outcome.error < kLostError ? fmt::format("{:.0e}", outcome.error) : fmt::format("**{:.0e}**", outcome.error);
}

const std::vector<CauseView>& causeViews()
{
  static const std::vector<CauseView> kAll{
      {"condition of the normal equations",
       [](const CauseOutcome& o) { return o.condition > 0 ? fmt::format("{:.0e}", o.condition) : "?"; }},
      {"error, normal equations as printed", [](const CauseOutcome& o) { return lossText(o.printed); }},
      {"error, corrected", [](const CauseOutcome& o) { return lossText(o.corrected); }},
      {"error, augmented", [](const CauseOutcome& o) { return lossText(o.augmented); }}};
  return kAll;
}

/// A plate with each recipe.
struct CauseRow {
  std::string plate;
  std::vector<CauseOutcome> byRecipe;
};

Table tableOf(const std::vector<CauseRow>& rows, const CauseView& view)
{
  Table table{{view.caption}, {}};
  for (const Recipe& recipe : allRecipes()) table.columns.emplace_back(recipe.name);
  for (const CauseRow& row : rows) {
    table.rows.push_back({row.plate});
    for (const CauseOutcome& outcome : row.byRecipe) table.rows.back().push_back(view.cell(outcome));
  }
  return table;
}

/// How far the shape of the plate without the cause is, at its vertices. Diagonals.
double distance(const Columns3& bad, const Columns3& sound)
{
  return (bad.topRows(sound.rows()) - sound).rowwise().norm().maxCoeff();
}

void addShapes(Section& section, const std::vector<CauseRow>& rows)
{
  const std::vector<Recipe>& recipes = allRecipes();
  const BentMesh sound = bentByEnds(soundPlate());
  std::vector<Columns3> shapes;
  Table table{{"distance to the shape of the sound plate"}, {}};
  for (const Recipe& recipe : recipes) {
    table.columns.emplace_back(recipe.name);
    shapes.push_back(outcomeOf(sound, recipe).u);
  }
  for (const CauseRow& row : rows) {
    table.rows.push_back({row.plate});
    for (std::size_t r = 0; r < recipes.size(); ++r) {
      const double away = distance(row.byRecipe[r].u, shapes[r]);
      table.rows.back().push_back(fmt::format("{:.0e}", away));
      section.numbers[fmt::format("{}, {}: shape", row.plate, recipes[r].name)] = away;
    }
  }
  section.tables.push_back(std::move(table));
}

void noteNumbers(Section& section, const CauseRow& row)
{
  for (std::size_t r = 0; r < allRecipes().size(); ++r) {
    const std::string name = fmt::format("{}, {}: ", row.plate, allRecipes()[r].name);
    const CauseOutcome& outcome = row.byRecipe[r];
    section.numbers[name + "condition"] = outcome.condition;
    section.numbers[name + "printed"] = outcome.printed.error;
    section.numbers[name + "corrected"] = outcome.corrected.error;
    section.numbers[name + "augmented"] = outcome.augmented.error;
  }
}

/// The largest of a number of a recipe over all plates.
double largest(const Section& section, const std::string& recipe, const std::string& number)
{
  double result = 0;
  for (const auto& [name, value] : section.numbers)
    if (name.ends_with(fmt::format(", {}: {}", recipe, number))) result = std::max(result, value);
  return result;
}

double largestOfAll(const Section& section, const std::string& number)
{
  double result = 0;
  for (const Recipe& recipe : allRecipes()) result = std::max(result, largest(section, recipe.name, number));
  return result;
}

}  // namespace

Section causesOfInstability(const Workbench& /*bench*/)
{
  Section section;
  section.paper =
      "cotangent weights fail on some meshes, by small angles and by small and large Voronoi areas; why and "
      "what helps is left as future work.";
  section.method =
      "plates of 1,000 to 6,000 vertices with one cause each, one end bent by 60 degrees under hard constraints. The "
      "number "
      "is the length or the area that is small, as a share of the usual one. Small angle: a vertex on an edge, beside "
      "its "
      "end. Flat angle: a vertex in a triangle, beside the middle of a side. Areas: right-angled triangles of all "
      "sizes. "
      "Cancelling area: obtuse angles of some 100 degrees. A column has (10), cotangent weights as printed, with what "
      "its "
      "head names. Errors are those to quadruple precision, as in Table 1; \"corrected\" is what the product does, "
      "\"augmented\" an LU factorisation of the equations with the residual as unknown, without a correction.";
  std::vector<CauseRow> rows;
  for (const Cause cause : allCauses())
    for (const double severity : {1e-2, 1e-4, 1e-6}) {
      const BentMesh bent = bentByEnds(badPlate(cause, severity));
      CauseRow row{fmt::format("{}, {:g}", name(cause), severity), {}};
      for (const Recipe& recipe : allRecipes()) row.byRecipe.push_back(outcomeOf(bent, recipe));
      noteNumbers(section, row);
      rows.push_back(std::move(row));
    }
  for (const CauseView& view : causeViews()) section.tables.push_back(tableOf(rows, view));
  rows.resize(6);  // plates that have the vertices of the sound one
  addShapes(section, rows);
  section.result = fmt::format(
      "Each cure serves against its own causes. Guarded cotangents cure small and flat angles. Intrinsic Delaunay "
      "edges "
      "cure flat angles and the areas that they cancel, and do nothing about a small angle across a short edge, where "
      "no "
      "edge can be flipped. Mixed areas cure areas that cancel; rows weighted by the root of the area cure areas of "
      "different sizes. All but the edges together are the default: its conditions are up to {:.0e}, where (10), "
      "cotangent "
      "weights as printed, reaches {:.0e}, and intrinsic Delaunay edges in place of the guard {:.0e}. Corrections "
      "leave "
      "{:.0e} of error at most with the default, and {:.0e} with any of these rows; augmented equations {:.0e} and "
      "{:.0e} "
      "without a correction. The price of the guard is the shape beside flat angles: {:.0e} of the diagonal from that "
      "of "
      "the sound plate, {:.0e} on intrinsic Delaunay edges.",
      largest(section, "default", "condition"), largest(section, "as printed", "condition"),
      largest(section, "default without guard, intrinsic Delaunay", "condition"),
      largest(section, "default", "corrected"), largestOfAll(section, "corrected"),
      largest(section, "default", "augmented"), largestOfAll(section, "augmented"),
      largest(section, "default", "shape"), largest(section, "default, intrinsic Delaunay", "shape"));
  return section;
}

}  // namespace holdfast::paper
