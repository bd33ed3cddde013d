#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkRenderWindow.h>

#include <holdfast/widgets/rotation_sphere/rotation_sphere.h>
#include <holdfast/widgets/scene/example_document.h>

#include "holdfast/widgets/interaction/vtkHoldfastRotationSphereStyle.h"
#include "interaction/interaction_fixture.h"
#include "support/meshes.h"
#include "widgets/sphere_place.h"

namespace holdfast {
namespace {

using test::EventLog;
using test::InteractionFixture;
using testing::ElementsAre;
using testing::IsEmpty;

/// The rotations of a small document on their sphere.
struct SphereInWindow : testing::Test {
  SphereInWindow()
  {
    fixture.renderer().RemoveAllViewProps();
    sphere.addTo(fixture.renderer());
    sphere.show(placeRotations(example.model, example.deformation, nullptr));
    sphere.fitCamera();
    style->SetSphere(&sphere);
    fixture.interactor().SetInteractorStyle(style);
    fixture.window().SetSize(400, 300);
  }

  [[nodiscard]] vtkCamera& camera() const { return *fixture.renderer().GetActiveCamera(); }
  [[nodiscard]] Vector3 eye() const { return Vector3(camera().GetPosition()); }

  InteractionFixture fixture{test::grid(1, 1)};
  const ExampleDocument example = exampleDocument();
  RotationSphere sphere;
  vtkNew<vtkHoldfastRotationSphereStyle> style;
};

TEST_F(SphereInWindow, ADragTurnsItAsIfTheHandHeldIt)
{
  const EventLog log(*style, {vtkCommand::StartInteractionEvent, vtkCommand::InteractionEvent,
                              vtkCommand::EndInteractionEvent, vtkCommand::PickEvent});
  const Vector3 before = eye();
  const double distance = before.norm();
  fixture.mouse().drag({{200, 150}, {240, 150}});
  EXPECT_GT((eye() - before).norm(), 0.5);
  EXPECT_NEAR(eye().norm(), distance, 1e-9);
  EXPECT_THAT(log.events(), ElementsAre(vtkCommand::StartInteractionEvent, vtkCommand::InteractionEvent,
                                        vtkCommand::EndInteractionEvent));
}

TEST_F(SphereInWindow, AClickPicksThePointUnderIt)
{
  std::optional<Index> vertex;
  for (Index v = 0; v < example.model.mesh.vertexCount() && !vertex; ++v)
    if (const auto place = test::displayPlace(sphere, v))
      if (sphere.pick(place->x(), place->y()) == v) vertex = v;
  ASSERT_TRUE(vertex);
  Index picked = -1;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&picked);
  command->SetCallback([](vtkObject*, unsigned long, void* result, void* data) {
    *static_cast<Index*>(result) = *static_cast<const Index*>(data);
  });
  style->AddObserver(vtkCommand::PickEvent, command);
  fixture.mouse().click({1, 1});
  EXPECT_EQ(picked, -1);
  fixture.mouse().click(test::displayPlace(sphere, *vertex).value());
  EXPECT_EQ(picked, *vertex);
}

TEST_F(SphereInWindow, WheelAndKeysZoomAndTurnAndADoubleClickShowsAll)
{
  const double scale = camera().GetParallelScale();
  fixture.mouse().wheel({200, 150}, 1);
  EXPECT_NEAR(camera().GetParallelScale(), scale / 1.2, 1e-12);
  fixture.mouse().key("minus");
  EXPECT_NEAR(camera().GetParallelScale(), scale, 1e-12);
  const Vector3 before = eye();
  fixture.mouse().key("Left");
  EXPECT_GT((eye() - before).norm(), 0.1);
  fixture.mouse().key("Right");
  EXPECT_LT((eye() - before).norm(), 1e-9);
  fixture.mouse().key("Up");
  fixture.mouse().key("plus");
  fixture.mouse().key("Home");
  EXPECT_EQ(eye(), before);
  EXPECT_EQ(camera().GetParallelScale(), scale);
  fixture.mouse().key("Down");
  fixture.mouse().doubleClick({200, 150});
  EXPECT_EQ(eye(), before);
}

TEST_F(SphereInWindow, WithoutASphereNothingHappens)
{
  style->SetSphere(nullptr);
  const EventLog log(*style, {vtkCommand::InteractionEvent, vtkCommand::PickEvent});
  const unsigned long before = camera().GetMTime();
  fixture.mouse().drag({{200, 150}, {240, 150}});
  fixture.mouse().doubleClick({200, 150});
  fixture.mouse().wheel({200, 150}, 1);
  fixture.mouse().key("Left");
  EXPECT_EQ(camera().GetMTime(), before);
  EXPECT_THAT(log.events(), IsEmpty());
}

}  // namespace
}  // namespace holdfast
