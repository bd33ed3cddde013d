#pragma once
/// \file
/// Short names of what widgets tell.

#include <holdfast/widgets/interaction/interaction_events.h>

namespace holdfast::test {

inline constexpr unsigned long kBegins = vtkCommand::StartInteractionEvent;
inline constexpr unsigned long kMoves = vtkCommand::InteractionEvent;
inline constexpr unsigned long kPlaces = vtkCommand::PlacePointEvent;
inline constexpr unsigned long kChanges = vtkCommand::WidgetValueChangedEvent;
inline constexpr unsigned long kEnds = vtkCommand::EndInteractionEvent;
inline constexpr unsigned long kCancels = CancelInteractionEvent;

}  // namespace holdfast::test
