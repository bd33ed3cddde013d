#include "inspected_sheet.h"

#include <QAbstractItemView>
#include <QLabel>
#include <QPushButton>

#include <holdfast/document/session_file.h>

#include "open_document.h"
#include "support/constraint_lists.h"
#include "support/meshes.h"

namespace holdfast::test {

void InspectedSheet::SetUp()
{
  ASSERT_TRUE(openMesh(editor, grid(10, 10), inspectedList()));
  panel.resize(380, 700);
  ASSERT_TRUE(showAndWait(panel));
}

ConstraintList InspectedSheet::inspectedList()
{
  ConstraintList list{"mm", {}};
  list.constraints = {
      {"base", true, FixedConstraint{{InHalfSpace{Vector3(0.5, 0, 0), Vector3(-1, 0, 0)}}}},
      {"P1", true, PointConstraint{AtVertex{36}, Target{Vector3(3, 2, 1)}}},
      {"P2", true, PointConstraint{AtEdge{48, 49, 0.25}, Move{Vector3(0, 0, 0.1)}}},
      {"P3", true, PointConstraint{AtFace{77, {0.25, 0.25, 0.5}}, Move{Vector3(0, 0, 0.1)}}},
  };
  HandleConstraint tip;
  tip.select.what = VertexIds{{118, 119, 120}};
  tip.motion.emplace<AxisRotation>();
  tip.translate = Vector3(0, 0, 2);
  list.constraints.push_back({"tip", true, tip});
  list.constraints.push_back({"pair", true, RelativeConstraint{AtVertex{60}, AtVertex{62}, {}}});
  return list;
}

void InspectedSheet::typeInto(const char* name, const char* text)
{
  QLineEdit& line = find(name);
  ASSERT_TRUE(line.isVisible()) << name;
  line.setFocus();
  line.selectAll();
  type(line, text);
  pressKey(line, Qt::Key_Return);
}

void InspectedSheet::choose(const char* name, int entry)
{
  QComboBox& box = find<QComboBox>(name);
  ASSERT_TRUE(box.isVisible()) << name;
  box.showPopup();
  box.view()->setCurrentIndex(box.model()->index(entry, 0));
  pressKey(*box.view(), Qt::Key_Return);
}

void InspectedSheet::press(const char* button)
{
  QPushButton& found = find<QPushButton>(button);
  ASSERT_TRUE(found.isVisible()) << button;
  click(found, QPointF(found.rect().center()));
}

std::string InspectedSheet::refusal()
{
  QLabel& label = find<QLabel>("inspectorRefusal");
  return label.isVisible() ? label.text().toStdString() : "";
}

void InspectedSheet::expectOneEntry(const std::shared_ptr<const DocumentState>& before, const char* name)
{
  EXPECT_NE(editor.history().state(), before);
  EXPECT_EQ(editor.history().undoName(), name);
  editor.undo();
  EXPECT_EQ(editor.history().state(), before) << "one entry";
  editor.redo();
}

void InspectedSheet::expectKeptInSession()
{
  const SessionFile session{{"sheet.obj", "", ""}, editor.state(), {}, ""};
  EXPECT_TRUE(areSame(parseSession(sessionToJson(session), "session").document.list, editor.list()));
}

}  // namespace holdfast::test
