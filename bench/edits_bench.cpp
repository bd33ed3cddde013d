// What another set of constraints costs: from nothing, on a mesh that is known, and as an edit of a few.

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bench/benchmarks.h"
#include "bench/dragged_mesh.h"
#include "bench/measure.h"
#include "bench/samples.h"
#include "bench/scenes.h"

namespace holdfast::bench {
namespace {

/// `list` without `count` of its points, from the one of this number on, of all kinds.
ConstraintList without(ConstraintList list, std::size_t count, std::size_t first)
{
  const std::size_t step = (list.constraints.size() - kEnds) / count;
  for (std::size_t k = count; k-- > 0;)
    list.constraints.erase(list.constraints.begin() + static_cast<std::ptrdiff_t>(kEnds + first + k * step));
  return list;
}

}  // namespace

void editsOfConstraints(benchmark::State& state, const Mesh& mesh)
{
  constexpr std::size_t kEdited = 20;
  constexpr char kAfterAnother[] = "20 others, right after another edit";
  const ConstraintList first = scene(mesh);
  const ConstraintList more = scene(mesh, 1);
  const ConstraintList other = without(more, kEdited, 0);
  const std::vector<std::pair<std::string, ConstraintList>> edits{
      {"1 fewer", without(other, 1, 0)}, {"20 fewer", without(other, kEdited, 1)}, {"20 more", more}};
  Samples samples;
  const auto add = [&](const std::string& row, double seconds, const DraggedMesh& dragged) {
    samples.add(row, "ms", 1000 * seconds);
    samples.add(row, "residual", dragged.report().maxResidualRelative);
  };
  for ([[maybe_unused]] auto turn : state) {
    std::unique_ptr<DraggedMesh> dragged;
    const double nothing = secondsOf([&] {
      dragged = std::make_unique<DraggedMesh>(mesh);
      dragged->deform(first);
    });
    add("from nothing", nothing, *dragged);
    add("frame", dragged->frame(first), *dragged);
    add("moved frame", dragged->movedFrame(first), *dragged);
    add("another set", dragged->deform(other), *dragged);
    for (const auto& [row, edited] : edits) {
      add(row, dragged->deform(edited), *dragged);
      add("frame after " + row, dragged->frame(edited), *dragged);
      dragged->deform(other);
    }
    dragged->deform(without(other, kEdited, 2));
    add(kAfterAnother, dragged->deform(without(other, kEdited, 3)), *dragged);
  }
  samples.addRatios("= of frame", {"moved frame", "ms"}, {"frame", "ms"});
  for (const char* row : {"another set", kAfterAnother})
    samples.addRatios("= of nothing", {row, "ms"}, {"from nothing", "ms"});
  for (const auto& [row, edited] : edits) {
    samples.addRatios("= of another set", {row, "ms"}, {"another set", "ms"});
    samples.addRatios("= of nothing", {row, "ms"}, {"from nothing", "ms"});
    samples.addRatios("= of frame", {"frame after " + row, "ms"}, {"frame", "ms"});
  }
  samples.report(state);
}

}  // namespace holdfast::bench
