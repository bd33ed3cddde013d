#include <holdfast/document/list_edits.h>

#include "chapters.h"
#include "window/gestures.h"

namespace holdfast::tour {
namespace {

/// Of a point that lies in a face.
Index faceOf(const Editor& editor, const std::string& constraint)
{
  const auto row = indexOf(editor.list(), constraint);
  require(row.has_value(), "there is a constraint " + constraint);
  return std::get<AtFace>(std::get<Point>(editor.list().constraints[*row].what).at).face;
}

}  // namespace

void opening(Stage& stage)
{
  stage.picture("empty");
  stage.openSession("bracket.holdfast");
  stage.picture("bracket_with_measured_points");

  stage.trigger("toolPoint");
  const Index corner = stage.nearestVertex({20, 10, 12});
  const auto& face = stage.editor().model()->mesh.faces[faceOf(stage.editor(), "gusset right")];
  const QPointF a = stage.shownVertex(face[0]);
  const QPointF b = stage.shownVertex(face[1]);
  const QPointF c = stage.shownVertex(face[2]);
  const auto preview = [&](Qt::Key key, const QPointF& place, const char* name) {
    test::pressKey(stage.viewport(), key);
    test::moveMouse(stage.viewport(), place);
    stage.picture(name);
  };
  preview(Qt::Key_V, stage.shownVertex(corner), "preview_of_a_vertex");
  preview(Qt::Key_E, (a + b) / 2, "preview_of_an_edge");
  preview(Qt::Key_F, (a + b + c) / 3, "preview_of_a_face");
  test::pressKey(stage.viewport(), Qt::Key_A);
  test::click(stage.viewport(), stage.shownVertex(corner));
  stage.settle();
  stage.picture("held_point");
  stage.trigger("undo");
  stage.trigger("toolSelect");
}

}  // namespace holdfast::tour
