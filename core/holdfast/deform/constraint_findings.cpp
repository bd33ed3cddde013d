#include "holdfast/deform/constraint_findings.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <holdfast/base/printable.h>
#include <holdfast/deform/outcomes.h>

namespace holdfast {
namespace {

/// A vertex of each part that stays at rest.
std::vector<Index> partsAtRest(const Model& model, const EliminatedConstraints& eliminated)
{
  std::vector<Index> atRest(static_cast<std::size_t>(model.solverMesh.componentCount), -1);
  for (Index u = 0; u < model.solverMesh.unknownCount(); ++u)
    if (const Index c = model.solverMesh.componentOf[u]; c >= 0 && eliminated.isHeld[u] && atRest[c] < 0)
      atRest[c] = model.solverMesh.weld.firstVertexOf[u];
  std::erase(atRest, -1);
  return atRest;
}

Finding nearlyDependent(std::vector<Index> spread, double largest)
{
  const std::string amount = fmt::format("a unit of inconsistency moves vertices by up to {:.2g} units; ", largest);
  return makeFinding(
      "nearly_dependent_constraints", "constraint", std::move(spread),
      {"constraint nearly follows from others: " + amount + "move its points apart, or leave it out",
       "constraints nearly follow from others: " + amount + "move their points apart, or leave some out"});
}

}  // namespace

std::vector<Finding> constraintFindings(const Model& model, const EliminatedConstraints& eliminated,
                                        const ConstraintSystem& system, const std::vector<ConstraintOutcome>& outcomes)
{
  std::vector<Finding> findings;
  if (std::vector<Index> atRest = partsAtRest(model, eliminated); !atRest.empty())
    findings.push_back(
        makeFinding("parts_at_rest", "vertex", std::move(atRest),
                    {"connected part has no constraint and stays at rest (a vertex of it is named)",
                     "connected parts have no constraint and stay at rest (a vertex of each is named)"}));
  std::vector<Index> spread;
  double largest = 0;
  for (std::size_t c = 0; c < outcomes.size(); ++c)
    if (const double sensitivity = outcomes[c].sensitivity.value_or(0); sensitivity > kLargeSensitivity) {
      spread.push_back(static_cast<Index>(c));
      largest = std::max(largest, sensitivity);
    }
  if (!spread.empty()) findings.push_back(nearlyDependent(std::move(spread), largest));
  for (const ConstraintNote& note : system.notes)
    findings.push_back({note.kind,
                        1,
                        "constraint",
                        {note.constraint},
                        fmt::format("{} {}", inQuotes(outcomes[note.constraint].name), note.message)});
  return findings;
}

}  // namespace holdfast
