// Several threads deform one model at once.

#include <array>
#include <cstring>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <holdfast/deform/deformer.h>
#include <holdfast/deform/report_json.h>

#include "support/latch.h"
#include "support/law_meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

constexpr std::size_t kCallers = 4;

/// This is what a call computes, without the times of the report.
struct Computed {
  Positions positions;
  Columns3 rotations;
  Columns3 multipliers;
  std::string outcomes;
};

template <class Matrix>
bool sameBits(const Matrix& a, const Matrix& b)
{
  return a.rows() == b.rows() && std::memcmp(a.data(), b.data(), sizeof(double) * a.size()) == 0;
}

bool isSame(const Computed& a, const Computed& b)
{
  return sameBits(a.positions, b.positions) && sameBits(a.rotations, b.rotations) &&
         sameBits(a.multipliers, b.multipliers) && a.outcomes == b.outcomes;
}

Computed computedOf(const DeformResult& result)
{
  return {result.positions, result.rotations, result.multipliers(), reportToCsv(result.report)};
}

std::shared_ptr<const Model> modelOfAPlate()
{
  return std::make_shared<const Model>(makeModel(test::plate(40, 30)));
}

/// Returns constraints with targets of the caller's own. The `near` place needs a search structure, which the model
/// makes when it is first asked.
ConstraintList listOfCaller(std::size_t caller)
{
  const double share = 0.1 * static_cast<double>(1 + caller);
  return test::listOf({test::hold({0, 1, 2, 41}),
                       test::handle({700, 701, 742}, AxisRotation{Vector3(1, 1, 0), 200 * share, Vector3(0, 0, 0)},
                                    Vector3(share, 0, 1)),
                       test::rigid({300, 301, 341, 342}),
                       {"", true, RelativeConstraint{AtVertex{320}, AtVertex{500}, {}}},
                       test::moveBy(AtFace{1500, {0.2, 0.3, 0.5}}, Vector3(0, share, 0)),
                       test::moveBy(AtNear{Vector3(33.3, 2.6, 1)}, Vector3(0, 0, share)),
                       test::moveBy(AtVertex{0}, Vector3(share, 0, 0))});  // contradicts the first
}

DeformOptions optionsOfCaller(std::size_t caller)
{
  DeformOptions options;
  if (caller % 2 != 0) options.rotations.source = RotationSource::Found;
  options.rotations.mostIterations = 4;
  return options;
}

/// Returns what a caller computes of a model: by the function, by the diagnosis, and by a deformer that shares it.
std::vector<Computed> computedBy(std::size_t caller, const std::shared_ptr<const Model>& model)
{
  ConstraintList list = listOfCaller(caller);
  const DeformOptions options = optionsOfCaller(caller);
  std::vector<Computed> all{computedOf(deform(*model, list, "list", options)),
                            {{}, {}, {}, reportToCsv(diagnoseConstraints(*model, list, "list", options))}};
  Deformer deformer(model, options);
  for (const double height : {0.5, 0.25}) {
    std::get<PointConstraint>(list.constraints[4].what).to = Move{Vector3(0, 0, height)};
    all.push_back(computedOf(deformer.deform(list)));
  }
  return all;
}

TEST(SharedModel, GivesEachOfSeveralThreadsWhatItGivesOneAlone)
{
  std::array<std::vector<Computed>, kCallers> alone;
  for (std::size_t caller = 0; caller < kCallers; ++caller) alone[caller] = computedBy(caller, modelOfAPlate());

  const std::shared_ptr<const Model> shared = modelOfAPlate();  // of which nobody has asked anything
  std::array<std::vector<Computed>, kCallers> together;
  test::Latch begin;
  {
    std::vector<std::jthread> callers;
    for (std::size_t caller = 0; caller < kCallers; ++caller)
      callers.emplace_back([&, caller] {
        if (begin.wait()) together[caller] = computedBy(caller, shared);
      });
    begin.open();
  }
  for (std::size_t caller = 0; caller < kCallers; ++caller) {
    ASSERT_EQ(together[caller].size(), alone[caller].size());
    for (std::size_t k = 0; k < alone[caller].size(); ++k)
      EXPECT_TRUE(isSame(together[caller][k], alone[caller][k])) << "caller " << caller << ", call " << k;
  }
}

TEST(SharedModelMustFail, ForTheResultOfAnotherCaller)
{
  const std::shared_ptr<const Model> model = modelOfAPlate();
  const std::vector<Computed> first = computedBy(0, model);
  const std::vector<Computed> third = computedBy(2, model);
  for (std::size_t k = 0; k < first.size(); ++k) EXPECT_FALSE(isSame(first[k], third[k])) << "call " << k;
}

}  // namespace
}  // namespace holdfast
