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
  return std::get<AtFace>(std::get<PointConstraint>(editor.list().constraints[*row].what).at).face;
}

}  // namespace

void opening(TourWindow& tour)
{
  tour.picture("empty");
  tour.openSession("bracket.holdfast");
  tour.picture("bracket_with_measured_points");

  tour.trigger("toolPoint");
  const Index corner = tour.nearestVertex({20, 10, 12});
  const auto& face = tour.editor().model()->mesh.faces[faceOf(tour.editor(), "gusset right")];
  const QPointF a = tour.shownVertex(face[0]);
  const QPointF b = tour.shownVertex(face[1]);
  const QPointF c = tour.shownVertex(face[2]);
  const auto preview = [&](Qt::Key key, const QPointF& place, const char* name) {
    test::pressKey(tour.viewport(), key);
    test::moveMouse(tour.viewport(), place);
    tour.picture(name);
  };
  preview(Qt::Key_V, tour.shownVertex(corner), "preview_of_a_vertex");
  preview(Qt::Key_E, (a + b) / 2, "preview_of_an_edge");
  preview(Qt::Key_F, (a + b + c) / 3, "preview_of_a_face");
  test::pressKey(tour.viewport(), Qt::Key_A);
  test::click(tour.viewport(), tour.shownVertex(corner));
  tour.settle();
  tour.picture("held_point");
  tour.trigger("undo");
  tour.trigger("toolSelect");
}

}  // namespace holdfast::tour
