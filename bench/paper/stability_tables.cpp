// Table 1 in full: soft constraints, Lagrange multipliers and hard constraints with three kinds of weights, in single
// and double precision, as printed and as the product solves them.

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include <holdfast/io/mesh_file.h>

#include "bench/bumpy_mesh.h"
#include "bench/paper/experiments.h"
#include "bench/paper/stability.h"

namespace holdfast::paper {
namespace {

using Rows = std::vector<StabilityRow>;

/// What one table shows of a row.
struct View {
  const char* caption;
  std::function<std::string(const StabilityRow&)> cell;
  bool isTime = false;
};

std::string errorText(const Outcome& outcome)
{
  if (!outcome.isSolved()) return fmt::format("**{}**", outcome.failure);
  if (std::isnan(outcome.error)) return "?";
  return outcome.error < kLostError ? fmt::format("{:.0e}", outcome.error) : fmt::format("**{:.0e}**", outcome.error);
}

std::string residualText(const Outcome& outcome)
{
  return outcome.isSolved() ? fmt::format("{:.0e}", outcome.residual) : "";
}

std::string secondsText(const Outcome& outcome)
{
  return outcome.isSolved() ? fmt::format("{:.2f}", outcome.seconds) : "";
}

const std::vector<View>& views()
{
  static const std::vector<View> kAll{
      {"error, single, as printed", [](const StabilityRow& row) { return errorText(row.inSingle); }},
      {"error, double, as printed", [](const StabilityRow& row) { return errorText(row.inDouble); }},
      {"error, as the product solves", [](const StabilityRow& row) { return errorText(row.byProduct); }},
      {"residual, single, as printed", [](const StabilityRow& row) { return residualText(row.inSingle); }},
      {"residual, double, as printed", [](const StabilityRow& row) { return residualText(row.inDouble); }},
      {"residual, as the product solves", [](const StabilityRow& row) { return residualText(row.byProduct); }},
      {"condition of the normal equations",
       [](const StabilityRow& row) { return row.condition > 0 ? fmt::format("{:.0e}", row.condition) : "?"; }},
      {"processor seconds, single, as printed", [](const StabilityRow& row) { return secondsText(row.inSingle); },
       true},
      {"processor seconds, double, as printed", [](const StabilityRow& row) { return secondsText(row.inDouble); },
       true},
      {"processor seconds, as the product solves", [](const StabilityRow& row) { return secondsText(row.byProduct); },
       true}};
  return kAll;
}

/// Seconds of systems that are solved in less are noise.
constexpr Index kWorthTiming = 10000;

/// A line for each mesh and kind of weights, a column for each method.
Table tableOf(const Rows& rows, const std::vector<Method>& methods, const View& view)
{
  Table table{{view.caption}, {}};
  for (const Method& method : methods) table.columns.push_back(text(method));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (k % methods.size() == 0) table.rows.push_back({fmt::format("{}, {}", rows[k].mesh, name(rows[k].weights))});
    table.rows.back().push_back(view.cell(rows[k]));
  }
  return table;
}

/// False where there is nothing to judge a solution by.
bool isLost(const Outcome& outcome)
{
  return !outcome.isSolved() || outcome.error >= kLostError;
}

/// What the tests look at: shares of systems that are lost, and largest errors and residuals of hard constraints.
void noteNumbers(Section& section, const Rows& rows)
{
  const auto count = [&](const Outcome StabilityRow::*outcome) {
    return static_cast<double>(
        std::ranges::count_if(rows, [&](const StabilityRow& row) { return isLost(row.*outcome); }));
  };
  auto& numbers = section.numbers;
  numbers["systems"] = static_cast<double>(rows.size());
  numbers["lost in single"] = count(&StabilityRow::inSingle);
  numbers["lost in double"] = count(&StabilityRow::inDouble);
  numbers["lost by product"] = count(&StabilityRow::byProduct);
  numbers["not finite"] = static_cast<double>(
      std::ranges::count_if(rows, [](const StabilityRow& row) { return row.byProduct.failure == kNotFinite; }));
  for (const StabilityRow& row : rows) {
    const auto raise = [&](const std::string& name, double value) { numbers[name] = std::max(numbers[name], value); };
    raise("reference error", row.referenceError);
    if (row.method.kind != SolverKind::Hard) continue;
    raise("hard error, single", row.inSingle.error);
    raise("hard error, double", row.inDouble.error);
    raise("hard error, product", row.byProduct.error);
    raise("hard residual, product", row.byProduct.residual);
  }
}

std::string resultOf(const Section& section)
{
  const auto at = [&](const char* name) { return section.numbers.at(name); };
  const std::string notFinite =
      at("not finite") > 0
          ? fmt::format(
                " {:.0f} systems are not finite: areas vanish, and (10), cotangent weights as printed, divides by "
                "them.",
                at("not finite"))
          : "";
  return fmt::format(
      "As printed, {:.0f} of {:.0f} systems are lost in single precision and {:.0f} in double precision: the "
      "factorisation fails or is stopped, rows are not finite, or vertices are wrong by {:g} of the diagonal or "
      "more. The product loses {:.0f}.{} Hard constraints that are solved are wrong by up to {:.0e} in single and "
      "{:.0e} in double precision as printed, by {:.0e} as the product solves them. Where the formulas fail, and "
      "what cures it. Soft constraints: the condition grows with the square of the weight, so a weight that meets "
      "constraints has no digits left; elimination has no weight. Cotangent weights as printed: rows of small areas "
      "outweigh all others; mixed areas and rows weighted by the root of the area cure it. Lagrange multipliers: "
      "rows of different sizes and an indefinite matrix, whose pivots grow; elimination leaves a positive definite "
      "one. Normal equations lose half of the digits; corrections by residuals through A bring them back.",
      at("lost in single"), at("systems"), at("lost in double"), kLostError, at("lost by product"), notFinite,
      at("hard error, single"), at("hard error, double"), at("hard error, product"));
}

struct NamedMesh {
  std::string name;
  Mesh mesh;
};

Section stabilityOf(const std::vector<NamedMesh>& meshes)
{
  const std::vector<Method> methods = allMethods();
  Section section;
  section.paper =
      "circles and crosses: which models are solved by soft constraints, with the weight 1 for normals and 5 for "
      "constraints, and by hard ones, with uniform and with cotangent weights. It has no numbers.";
  section.method = fmt::format(
      "one end of each mesh is fixed, the other one moved and turned by 60 degrees, and points on vertices, on edges "
      "and in faces are moved. \"As printed\" solves for positions by the normal equations as they stand, with a "
      "plain factorisation (CHOLMOD in double, Eigen in single precision; for Lagrange multipliers LU without "
      "scaling, by UMFPACK and by Eigen, which is stopped after {} s of processor time or at {} GB of addresses). An "
      "error is the largest distance of a vertex to the solution of the same equations in quadruple precision, a "
      "residual that of a constraint to its target, both as shares of the diagonal. Seconds are those of all cores. "
      "Errors from {:g} on and failures are bold; \"?\" stands where no factor in doubles is good enough for a "
      "reference.",
      kLuLimits.seconds, kLuLimits.gigabytes, kLostError);
  Rows rows;
  for (const NamedMesh& mesh : meshes)
    measureStability(mesh.name, mesh.mesh, methods, [&](const StabilityRow& row) { rows.push_back(row); });
  const bool isTimed = std::ranges::any_of(rows, [](const StabilityRow& row) { return row.unknowns >= kWorthTiming; });
  for (const View& view : views())
    if (isTimed || !view.isTime) section.tables.push_back(tableOf(rows, methods, view));
  noteNumbers(section, rows);
  section.result = resultOf(section);
  return section;
}

}  // namespace

Section stabilityOfOwnMeshes(const Workbench& /*bench*/)
{
  return stabilityOf({{"bar", readMesh("data/bar.obj").mesh},
                      {"unsymmetric plate", readMesh("data/plate_unsymmetric.off").mesh},
                      {"shaft with slivers", readMesh("data/shaft_slivers.off").mesh},
                      {"generated, 2k", bench::bumpyMesh(2000)}});
}

Section stabilityOfModels(const Workbench& bench)
{
  std::vector<NamedMesh> meshes;
  for (const std::string file : {"bunny.ply", "armadillo.off", "anchor.off"})
    meshes.push_back({file, readMesh(bench.model(file)).mesh});
  return stabilityOf(meshes);
}

Section stabilityOfDragon(const Workbench& bench)
{
  return stabilityOf({{"dragon.ply", readMesh(bench.model("dragon.ply")).mesh}});
}

}  // namespace holdfast::paper
