#include <QPushButton>

#include "chapters.h"
#include "window/gestures.h"

namespace holdfast::tour {

void conflicts(Stage& stage)
{
  stage.open("bracket.obj", "bracket.conflict.constraints.json");
  stage.raise("conflictsDock");
  stage.picture("conflicts");
  auto& card = stage.find<QWidget>("conflict0");
  card.findChild<QPushButton*>("conflictSelect")->click();
  stage.settle();
  stage.picture("set_of_a_conflict_selected");
  card.findChild<QPushButton*>("conflictRetarget")->click();
  stage.settle();
  stage.picture("consistent_target_used");

  stage.open("cube_unwelded.stl", "cube_unwelded.constraints.json");
  stage.raise("findingsDock");
  stage.picture("findings_of_an_unwelded_mesh");
  stage.open("two_parts.obj", "two_parts.constraints.json");
  stage.picture("findings_of_two_parts");
  stage.open("bracket.obj", "bracket.constraints.json");
  stage.picture("no_findings");
  stage.raise("reportDock");
  stage.picture("report_of_the_solution");
  stage.raise("inspectorDock");
}

}  // namespace holdfast::tour
