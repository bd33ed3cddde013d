#include "holdfast/window/model/commands.h"

#include <QObject>
#include <algorithm>

#include <holdfast/document/list_edits.h>
#include <holdfast/window/text/constraint_text.h>

namespace holdfast {
namespace {

void add(Editor& editor, Constraint constraint)
{
  const QString name = QObject::tr("add %1").arg(nameText(constraint.name));
  ConstraintList list = added(editor.list(), std::move(constraint));
  const Index last = static_cast<Index>(list.constraints.size()) - 1;
  editor.edit(name, std::move(list));
  editor.selectConstraints({last});
}

const char* stemOf(RegionKind kind)
{
  switch (kind) {
    case RegionKind::Fixed:
      return "fixed ";
    case RegionKind::Handle:
      return "handle ";
    case RegionKind::Rigid:
      break;
  }
  return "rigid ";
}

/// "P1", or how many there are.
QString namesOf(const Editor& editor)
{
  const auto& selected = editor.selectedConstraints();
  if (selected.size() == 1) return nameText(editor.list().constraints[selected.front()].name);
  return QObject::tr("%n constraint(s)").replace("%n", QString::number(selected.size())).replace("(s)", "s");
}

}  // namespace

void holdPoint(Editor& editor, const SurfacePick& pick)
{
  add(editor, {unusedName(editor.list(), "P"), true, PointConstraint{pick.location, Target{pick.place}}});
}

void keepVector(Editor& editor, const SurfaceLocation& from, const SurfaceLocation& to)
{
  add(editor, {unusedName(editor.list(), "vector "), true, RelativeConstraint{from, to, {}}});
}

void constrainSelection(Editor& editor, RegionKind kind)
{
  Constraint constraint;
  constraint.name = unusedName(editor.list(), stemOf(kind));
  const Selection select = editor.selection();
  switch (kind) {
    case RegionKind::Fixed:
      constraint.what = FixedConstraint{select};
      break;
    case RegionKind::Handle:
      constraint.what = HandleConstraint{select, {}, Vector3::Zero(), {}};
      break;
    case RegionKind::Rigid:
      constraint.what = RigidConstraint{select};
      break;
  }
  editor.selectVertices({});
  add(editor, std::move(constraint));
}

void removeSelectedConstraints(Editor& editor)
{
  const auto selected = editor.selectedConstraints();
  if (selected.empty()) return;
  const QString name = QObject::tr("delete %1").arg(namesOf(editor));
  editor.selectConstraints({});
  editor.edit(name, removed(editor.list(), selected));
}

void toggleSelectedConstraints(Editor& editor)
{
  const auto& selected = editor.selectedConstraints();
  if (selected.empty()) return;
  const bool areAllEnabled =
      std::all_of(selected.begin(), selected.end(), [&](Index k) { return editor.list().constraints[k].isEnabled; });
  const QString name = (areAllEnabled ? QObject::tr("disable %1") : QObject::tr("enable %1")).arg(namesOf(editor));
  editor.edit(name, withEnabled(editor.list(), selected, areAllEnabled ? Enabling::Disabled : Enabling::Enabled));
}

}  // namespace holdfast
