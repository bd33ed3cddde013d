#include <cmath>

#include <gtest/gtest.h>

#include <holdfast/deform/fields.h>

#include "support/law_meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

/// A plate of the size `scale`: one end held, the other bent, a point of a face between them raised.
struct BentPlate {
  BentPlate(const DeformOptions& options, double scale)
      : model(makeModel(test::transformed(test::plate(6, 5), Eigen::Affine3d(Eigen::Scaling(scale))), "mesh"))
  {
    const Vector3 center(5 * scale, 2 * scale, 0);
    const ConstraintList list = test::listOf(
        {test::hold({0, 7, 14}), test::handle({6, 13, 20}, AxisRotation{{0, 1, 0}, 50, center}, {0, 0, scale}),
         test::moveBy(AtFace{30, {0.25, 0.25, 0.5}}, {0, 0, scale / 4})});
    NoProgress progress;
    deformation = deform(model, list, "list", options, progress);
  }

  Model model;
  DeformResult deformation;
};

/// What the values of a field are multiplied by where lengths are multiplied by `scale`.
double factorOf(FieldKind kind, Weights weights, double scale)
{
  switch (kind) {
    case FieldKind::Displacement:
      return scale;
    case FieldKind::DetailResidual:
      return weights == Weights::Uniform ? scale : 1 / scale;
    default:
      return 1;
  }
}

void expectScaled(const std::vector<double>& values, const std::vector<double>& units, double factor)
{
  double largest = 0;
  for (const double unit : units) largest = std::fmax(largest, std::abs(unit));
  ASSERT_EQ(values.size(), units.size());
  ASSERT_GT(largest, 0);
  for (std::size_t k = 0; k < values.size(); ++k) {
    ASSERT_EQ(std::isnan(values[k]), std::isnan(units[k])) << k;
    if (std::isnan(units[k])) continue;
    ASSERT_NEAR(values[k] / factor, units[k], 1e-9 * largest) << k;
  }
}

TEST(Fields, AreThoseOfAnyScale)
{
  for (const Weights weights : test::allWeights())
    for (const int exponent : {-900, -530, 530, 900}) {
      const DeformOptions options{weights, {}};
      const double scale = std::ldexp(1.0, exponent);
      const BentPlate unit(options, 1);
      const BentPlate scaled(options, scale);
      ASSERT_EQ(scaled.deformation.report.solve.status, SolveStatus::Ok)
          << scaled.deformation.report.solve.message << ", 2^" << exponent;
      for (const FieldKind kind :
           {FieldKind::Displacement, FieldKind::RotationLog, FieldKind::ConstraintForce, FieldKind::DetailResidual}) {
        SCOPED_TRACE(fieldOf(unit.model, unit.deformation, kind).name + ", " + std::string(name(weights)) + ", 2^" +
                     std::to_string(exponent));
        expectScaled(fieldOf(scaled.model, scaled.deformation, kind).values,
                     fieldOf(unit.model, unit.deformation, kind).values, factorOf(kind, weights, scale));
      }
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(*scaled.deformation.report.constraints[c].multiplier,
                    *unit.deformation.report.constraints[c].multiplier,
                    1e-9 * *unit.deformation.report.constraints[c].multiplier)
            << "2^" << exponent;
    }
}

TEST(Fields, GrowWithMovesOfAnyLength)
{
  const Model model = makeModel(test::plate(6, 5), "mesh");
  const auto bent = [&](double length) {
    NoProgress progress;
    return deform(model, test::listOf({test::hold({0, 7, 14}), test::moveBy(AtVertex{20}, {0, 0, length})}), "list", {},
                  progress);
  };
  const double length = std::ldexp(1.0, 700);
  const DeformResult unit = bent(1);
  const DeformResult large = bent(length);
  for (const FieldKind kind : {FieldKind::Displacement, FieldKind::ConstraintForce, FieldKind::DetailResidual}) {
    SCOPED_TRACE(fieldOf(model, unit, kind).name);
    expectScaled(fieldOf(model, large, kind).values, fieldOf(model, unit, kind).values, length);
  }
  EXPECT_NEAR(*large.report.constraints[1].multiplier / length, *unit.report.constraints[1].multiplier,
              1e-9 * *unit.report.constraints[1].multiplier);
}

}  // namespace
}  // namespace holdfast
