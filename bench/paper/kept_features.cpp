// Fig. 7 and 8: features of a face that keep their shape, and a distance that is kept.

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/io/mesh_file.h>
#include <holdfast/surface/surface_locator.h>

#include "bench/paper/experiments.h"
#include "bench/paper/panels.h"
#include "bench/paper/shape_measures.h"

namespace holdfast::paper {
namespace {

constexpr const char* kHead = "data/head.ply";
constexpr const char* kRigidEyes = "data/head.rigid_eyes.constraints.json";

/// The same list without constraints of type `What`.
template <class What>
ConstraintList without(ConstraintList list)
{
  for (Constraint& constraint : list.constraints)
    if (std::holds_alternative<What>(constraint.what)) constraint.isEnabled = false;
  return list;
}

const Constraint& named(const ConstraintList& list, const std::string& name)
{
  return *std::ranges::find(list.constraints, name, &Constraint::name);
}

std::vector<Index> regionOf(const Model& head, const ConstraintList& list, const std::string& name)
{
  return verticesOf(head, std::get<RigidConstraint>(named(list, name).what).select);
}

/// The neck stays, the nose is pulled, and the vector from it to the mouth is kept.
ConstraintList pulledNose()
{
  const SurfaceLocation nose = AtNear{{0, -104, 0}};
  return {"mm",
          {{"neck", true, FixedConstraint{{InHalfSpace{{0, 0, -92}, {0, 0, -1}}}}},
           {"crown", true, FixedConstraint{{InHalfSpace{{0, 0, 92}, {0, 0, 1}}}}},
           {"nose tip", true, PointConstraint{nose, Move{{0, -22, 8}}}},
           {"mouth to nose", true, RelativeConstraint{AtNear{{0, -84, -32}}, nose, {}}}}};
}

double distanceBetweenEnds(const Model& head, const Positions& shape, const RelativeConstraint& kept)
{
  const auto placeOf = [&](const SurfaceLocation& location) {
    return positionOf(head.locator().locate(location, {"experiment", 0, ""}), shape);
  };
  return (placeOf(kept.from) - placeOf(kept.to)).norm();
}

/// Changes of edge lengths up to 5 %.
Panel eyePanel(const char* label, const Deformed& shown)
{
  return {label, &shown, ColorBy::EdgeChange, MeshEdges::Sharp, RestGhost::Hidden, {}, FixedRange{-5, 5}};
}

}  // namespace

Section rigidEyes(const Workbench& bench)
{
  const Model head = makeModel(readMesh(kHead).mesh, kHead);
  const ConstraintList list = readConstraints(kRigidEyes);
  const std::string free = bench.write("figure_07_free.constraints.json", without<RigidConstraint>(list));
  Section section;
  section.paper = "a face that is deformed with its eyes as rigid regions, drawn as closed curves.";
  section.method =
      "the head of `data/`, leaning by 30 degrees, with and without its rigid regions. Stretch is the "
      "relative change of length of the edges in the region of an eye.";
  Table table{{"eye", "without, RMS", "largest", "rigid, RMS", "largest"}, {}};
  const BatchRun before = bench.deform("figure_07_free", kHead, free);
  const BatchRun after = bench.deform("figure_07_rigid", kHead, kRigidEyes);
  section.commands = {before.command, after.command};
  std::vector<Index> eyes;
  for (const std::string eye : {"left eye", "right eye"}) {
    const std::vector<Index> region = regionOf(head, list, eye);
    eyes.insert(eyes.end(), region.begin(), region.end());
    const Spread loose = stretchOf(head, before.mesh.positions, region);
    const Spread rigid = stretchOf(head, after.mesh.positions, region);
    section.numbers[eye + " without"] = loose.largest;
    section.numbers[eye + " rigid"] = rigid.largest;
    table.rows.push_back({eye, fmt::format("{:.1e}", loose.rms), fmt::format("{:.1e}", loose.largest),
                          fmt::format("{:.1e}", rigid.rms), fmt::format("{:.1e}", rigid.largest)});
  }
  section.tables = {table};
  section.result =
      fmt::format("Free eyes stretch by up to {:.0f} %, rigid ones by rounding alone.",
                  100 * std::max(section.numbers["left eye without"], section.numbers["right eye without"]));
  const Deformed loose = deformed(kHead, free);
  const Deformed rigid = deformed(kHead, kRigidEyes);
  drawPanels(bench.picture("figure_07.png"),
             {eyePanel("(a) without rigid regions", loose), eyePanel("(b) rigid eyes", rigid)},
             {.back = {0, -1, 0.1}, .up = {0, 0, 1}, .panel = {360, 300}, .columns = 2, .focus = eyes});
  section.pictures = {{"figure_07.png", "The eyes coloured by the change of edge lengths: free, and rigid", true}};
  return section;
}

Section keptDistance(const Workbench& bench)
{
  const Model head = makeModel(readMesh(kHead).mesh, kHead);
  const ConstraintList list = pulledNose();
  const auto& kept = std::get<RelativeConstraint>(list.constraints.back().what);
  const std::string with = bench.write("figure_08_kept.constraints.json", list);
  const std::string free = bench.write("figure_08_free.constraints.json", without<RelativeConstraint>(list));
  Section section;
  section.paper = "the distance of two places of the surface is kept while it deforms.";
  section.method = "the nose of the head is pulled by 23 mm; the mouth is free, or keeps its vector to the nose.";
  const double rest = distanceBetweenEnds(head, head.mesh.positions, kept);
  const BatchRun loose = bench.deform("figure_08_free", kHead, free);
  const BatchRun tied = bench.deform("figure_08_kept", kHead, with);
  section.commands = {loose.command, tied.command};
  section.numbers = {{"rest", rest},
                     {"free", distanceBetweenEnds(head, loose.mesh.positions, kept)},
                     {"kept", distanceBetweenEnds(head, tied.mesh.positions, kept)}};
  section.tables = {{{"", "distance, mm", "less that at rest, mm"}, {}}};
  for (const char* name : {"rest", "free", "kept"})
    section.tables[0].rows.push_back(
        {name, fmt::format("{:.6f}", section.numbers[name]), fmt::format("{:.1e}", section.numbers[name] - rest)});
  section.result = fmt::format("The free distance grows by {:.0f} %, the kept one changes by rounding alone.",
                               100 * (section.numbers["free"] / rest - 1));
  const Deformed looseShown = deformed(kHead, free);
  const Deformed tiedShown = deformed(kHead, with);
  drawPanels(
      bench.picture("figure_08.png"),
      {{"(a) free", &looseShown, ColorBy::Displacement}, {"(b) kept distance", &tiedShown, ColorBy::Displacement}},
      {.back = {1, -0.6, 0.1}, .up = {0, 0, 1}, .panel = {420, 460}, .columns = 2});
  section.pictures = {{"figure_08.png", "The pulled nose: the mouth is free, or keeps its vector to the nose", true}};
  return section;
}

}  // namespace holdfast::paper
