#include <QPushButton>

#include "chapters.h"
#include "window/gestures.h"

namespace holdfast::tour {

void conflicts(TourWindow& tour)
{
  tour.open("bracket.obj", "bracket.conflict.constraints.json");
  tour.raise("conflictsDock");
  tour.picture("conflicts");
  auto& card = tour.find<QWidget>("conflict0");
  card.findChild<QPushButton*>("conflictSelect")->click();
  tour.settle();
  tour.picture("set_of_a_conflict_selected");
  card.findChild<QPushButton*>("conflictRetarget")->click();
  tour.settle();
  tour.picture("consistent_target_used");

  tour.open("cube_unwelded.stl", "cube_unwelded.constraints.json");
  tour.raise("findingsDock");
  tour.picture("findings_of_an_unwelded_mesh");
  tour.open("two_parts.obj", "two_parts.constraints.json");
  tour.picture("findings_of_two_parts");
  tour.open("bracket.obj", "bracket.constraints.json");
  tour.picture("no_findings");
  tour.raise("reportDock");
  tour.picture("report_of_the_solution");
  tour.raise("inspectorDock");
}

}  // namespace holdfast::tour
