#include "holdfast/deform/factor_store.h"

#include <gtest/gtest.h>

#include <holdfast/surface/surface_locator.h>

#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

/// A plate that is held at one corner, and a store of its factors.
class FactorStoreOfPlate : public testing::Test {
 protected:
  [[nodiscard]] FactorStore storeFor(DeformerMode mode) const { return {model_, {}, mode}; }

  [[nodiscard]] ConstraintSystem system(const std::vector<Constraint>& points) const
  {
    ConstraintList list = test::listOf({test::hold({0, 1, 2, 3})});
    list.constraints.insert(list.constraints.end(), points.begin(), points.end());
    return makeConstraintSystem(list, model_->mesh, model_->solverMesh, model_->locator(), "list");
  }

  static ConstraintFactorization& serving(FactorStore& store, const ConstraintSystem& system)
  {
    store.orderUnknowns(noProgress());
    return store.serving(system, noProgress());
  }

  /// The same with a factor.
  static ConstraintFactorization& factorised(FactorStore& store, const ConstraintSystem& system)
  {
    ConstraintFactorization& result = serving(store, system);
    EXPECT_TRUE(result.positions.result(noProgress()));
    return result;
  }

  static Constraint lift(Index vertex, double height) { return test::moveBy(AtVertex{vertex}, {0, 0, height}); }

  std::shared_ptr<const Model> model_ = std::make_shared<const Model>(makeModel(test::plate(16, 12)));
};

TEST_F(FactorStoreOfPlate, ServesOtherTargetsByTheSameFactor)
{
  FactorStore store = storeFor(DeformerMode::Repeatable);
  const ConstraintFactorization* const first = &serving(store, system({lift(60, 1)}));
  EXPECT_EQ(&serving(store, system({lift(60, 2)})), first);
  EXPECT_TRUE(first->serves(system({lift(60, 3)})));
  EXPECT_FALSE(first->serves(system({lift(61, 1)})));
}

TEST_F(FactorStoreOfPlate, MakesNewFactorsOfOtherRowsWhereCallsAreRepeatable)
{
  FactorStore store = storeFor(DeformerMode::Repeatable);
  EXPECT_FALSE(factorised(store, system({lift(60, 1)})).isBordered);
  const ConstraintFactorization* const second = &factorised(store, system({lift(60, 1), lift(70, 1)}));
  EXPECT_FALSE(second->isBordered);
  EXPECT_TRUE(second->moved.empty()) << "no solution is a sum of earlier ones";
  EXPECT_EQ(&store.operators(noProgress()), &store.operators(noProgress()));
}

TEST_F(FactorStoreOfPlate, BordersFewRowsUntilTheirOwnFactorIsThere)
{
  FactorStore store = storeFor(DeformerMode::Interactive);
  const ConstraintSystem before = system({lift(60, 1)});
  const ConstraintSystem edited = system({lift(60, 1), lift(70, 1)});
  const ConstraintFactorization& whole = factorised(store, before);
  const ConstraintFactorization& bordered = serving(store, edited);
  EXPECT_TRUE(bordered.isBordered);
  EXPECT_EQ(bordered.moved.size(), 1U);
  EXPECT_EQ(&serving(store, edited), &bordered) << "its own is not there yet";
  ConstraintFactorization& own = store.unbordered();
  EXPECT_FALSE(own.isBordered);
  EXPECT_TRUE(own.positions.result(noProgress()));
  EXPECT_EQ(&serving(store, edited), &own);
  EXPECT_NE(&own, &whole);
}

TEST_F(FactorStoreOfPlate, GoesBackToTheFactorThatEditsBeganWith)
{
  FactorStore store = storeFor(DeformerMode::Interactive);
  const ConstraintSystem before = system({lift(60, 1)});
  const ConstraintFactorization& whole = factorised(store, before);
  EXPECT_TRUE(serving(store, system({lift(60, 1), lift(70, 1)})).isBordered);
  EXPECT_EQ(&serving(store, before), &whole);
}

TEST_F(FactorStoreOfPlate, BordersNothingWhereOtherRotationsAreGiven)
{
  FactorStore store = storeFor(DeformerMode::Interactive);
  static_cast<void>(factorised(store, system({lift(60, 1)})));
  const Constraint handle{
      "turned", true,
      HandleConstraint{{VertexIds{{70, 71}}}, AxisRotation{Vector3::UnitX(), 20, {}}, Vector3::Zero(), {}}};
  EXPECT_FALSE(serving(store, system({lift(60, 1), handle})).isBordered);
}

TEST_F(FactorStoreOfPlate, HasFewerRowsOnlyWhereManyPointsNearlyDepend)
{
  FactorStore store = storeFor(DeformerMode::Repeatable);
  const ConstraintSystem few = system({lift(60, 1)});
  static_cast<void>(serving(store, few));
  EXPECT_EQ(store.withFewerRows(few, 1e-6, noProgress()), nullptr);

  // Forty points, and of each another one beside it, as near as 1e-8 of a face.
  std::vector<Constraint> points;
  for (Index k = 0; k < 40; ++k) {
    const Index face = 4 * k + 20;
    for (const double aside : {0.0, 1e-8})
      points.push_back(test::moveBy(AtFace{face, {0.25 + aside, 0.25, 0.5 - aside}}, {0, 0, 1}));
    points.push_back(test::moveBy(AtFace{face, {0.6, 0.2, 0.2}}, {0, 0, 1}));
  }
  const ConstraintSystem crowded = system(points);
  ConstraintFactorization& all = serving(store, crowded);
  ASSERT_TRUE(all.mayHaveFewerRows);
  EXPECT_EQ(store.withFewerRows(crowded, 0, noProgress()), nullptr);
  ConstraintFactorization* const fewer = store.withFewerRows(crowded, 1e-6, noProgress());
  ASSERT_NE(fewer, nullptr);
  EXPECT_GE(fewer->eliminated->parts().front().eliminated->dependencies.size(), 40U);
  EXPECT_EQ(&serving(store, crowded), fewer) << "it is at hand";
}

TEST_F(FactorStoreOfPlate, SaysThatThereIsOneCallAlone)
{
  FactorStore once = storeFor(DeformerMode::OneCall);
  EXPECT_TRUE(serving(once, system({lift(60, 1)})).isForOneCall);
  FactorStore store = storeFor(DeformerMode::Repeatable);
  EXPECT_FALSE(serving(store, system({lift(60, 1)})).isForOneCall);
}

}  // namespace
}  // namespace holdfast
