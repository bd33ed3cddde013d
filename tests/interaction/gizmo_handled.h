#pragma once
/// \file
/// A gizmo that a hand drags, and what it tells of that.

#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/interaction/vtkHoldfastGizmoRepresentation.h>
#include <holdfast/widgets/interaction/vtkHoldfastGizmoWidget.h>

#include "interaction/gizmo_fixture.h"

namespace holdfast::test {

/// The gizmo stands at (1.5, 1, 0), its axes are those of the world.
struct GizmoHandled : testing::Test {
  GizmoFixture fixture;
  vtkNew<vtkHoldfastGizmoWidget> widget;
  vtkHoldfastGizmoRepresentation& gizmo = *widget->GetGizmoRepresentation();
  Mouse& mouse = fixture.mouse();
  DisplayPoint beside{5, 5};
  std::vector<GizmoPart> parts;
  std::vector<GizmoMotion> motions;
  std::function<void()> atMotion = [] {};
  EventLog log{*widget,
               {vtkCommand::StartInteractionEvent, vtkCommand::InteractionEvent, vtkCommand::EndInteractionEvent,
                CancelInteractionEvent}};

  GizmoHandled()
  {
    gizmo.SetPixelSize(kGizmoRadius);
    gizmo.SetFrame({1.5, 1, 0}, Eigen::Matrix3d::Identity());
    widget->SetInteractor(&fixture.interactor());
    widget->On();
    widget->AddObserver(vtkCommand::HighlightEvent, this, &GizmoHandled::notePart);
    widget->AddObserver(vtkCommand::InteractionEvent, this, &GizmoHandled::noteMotion);
  }

  void notePart(vtkObject*, unsigned long, void* part) { parts.push_back(*static_cast<GizmoPart*>(part)); }
  void noteMotion(vtkObject*, unsigned long, void* motion)
  {
    motions.push_back(*static_cast<GizmoMotion*>(motion));
    atMotion();
  }

  void standElsewhere() { gizmo.SetFrame({8, 8, 8}, Eigen::Matrix3d::Identity()); }

  [[nodiscard]] unsigned long lastEvent() const { return log.events().empty() ? 0 : log.events().back(); }
  [[nodiscard]] DisplayPoint arrow(int axis) const { return placeOnArrow(gizmo, axis); }
  [[nodiscard]] const Vector3& center() const { return gizmo.GetFrame().center; }

  /// Presses an arrow and moves on, along it on the display.
  void grabArrow(int axis, double pixels = 40)
  {
    const DisplayPoint from = arrow(axis);
    const DisplayPoint along = (from - placeOnGizmo(gizmo, Vector3::Zero())).normalized();
    mouse.moveTo(from);
    mouse.press(from);
    mouse.moveTo(from + pixels * along);
  }
};

}  // namespace holdfast::test
