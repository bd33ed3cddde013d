#include "holdfast/window/model/constraint_actions.h"

#include <QClipboard>
#include <QFileInfo>
#include <QGuiApplication>
#include <QObject>
#include <algorithm>
#include <numeric>
#include <utility>

#include <holdfast/document/point_lists.h>
#include <holdfast/window/text/constraint_text.h>

namespace holdfast {
namespace {

Index sizeOf(const ConstraintList& list)
{
  return static_cast<Index>(list.constraints.size());
}

Rows rowsFrom(Index first, Index count)
{
  Rows rows(static_cast<std::size_t>(count));
  std::iota(rows.begin(), rows.end(), first);
  return rows;
}

void append(Editor& editor, const QString& name, const ConstraintList& more)
{
  const Index before = sizeOf(editor.list());
  editor.edit(name, pasted(editor.list(), more));
  editor.selectConstraints(rowsFrom(before, sizeOf(editor.list()) - before));
}

}  // namespace

QString subjectOf(const Editor& editor, const Rows& rows)
{
  if (rows.size() == 1) return nameText(editor.list().constraints[rows.front()].name);
  return QObject::tr("%n constraints", nullptr, static_cast<int>(rows.size()));
}

void changeConstraints(Editor& editor, const QString& name, const Rows& rows, const Change& change)
{
  ConstraintList list = editor.list();
  bool isChanged = false;
  for (const Index row : rows)
    if (std::optional<Constraint> after = change(list.constraints[row])) {
      list.constraints[row] = std::move(*after);
      isChanged = true;
    }
  if (isChanged) editor.edit(name, std::move(list));
}

void addConstraint(Editor& editor, const char* stem, decltype(Constraint::what) what)
{
  Constraint constraint{unusedName(editor.list(), stem), true, std::move(what)};
  const QString name = QObject::tr("add %1").arg(nameText(constraint.name));
  editor.edit(name, added(editor.list(), std::move(constraint)));
  editor.selectConstraints({sizeOf(editor.list()) - 1});
}

void keepOnMesh(Editor& editor, const Rows& rows, const OnMesh& on)
{
  if (rows.empty()) {
    SlideConstraint slide{editor.selection(), on};
    editor.selectVertices({});
    return addConstraint(editor, "slide ", std::move(slide));
  }
  const QString name = QObject::tr("keep %1 on %2");
  const QString file = QFileInfo(QString::fromStdString(on.path)).fileName();
  changeConstraints(editor, name.arg(subjectOf(editor, rows), file), rows, [&](Constraint changed) {
    const auto put = [&](auto& what, auto& guide) {
      guide = on;
      if (validateTolerance(what.within, what.directions())) what.within = Exactly{};
    };
    if (auto* point = std::get_if<PointConstraint>(&changed.what)) put(*point, point->to);
    if (auto* slide = std::get_if<SlideConstraint>(&changed.what)) {
      put(*slide, slide->on);
      slide->together = false;
    }
    return std::optional(changed);
  });
}

void holdPoint(Editor& editor, const SurfacePick& pick)
{
  addConstraint(editor, "P", PointConstraint{pick.location, Target{pick.place}});
}

void switchConstraints(Editor& editor, const Rows& rows, Enabling enabling)
{
  if (rows.empty()) return;
  const bool isOn = enabling == Enabling::Enabled;
  const QString name = isOn ? QObject::tr("enable %1") : QObject::tr("disable %1");
  editor.edit(name.arg(subjectOf(editor, rows)), withEnabled(editor.list(), rows, enabling));
}

void toggleConstraints(Editor& editor, const Rows& rows)
{
  const auto& constraints = editor.list().constraints;
  const bool areOn = std::all_of(rows.begin(), rows.end(), [&](Index row) { return constraints[row].isEnabled; });
  switchConstraints(editor, rows, areOn ? Enabling::Disabled : Enabling::Enabled);
}

void renameConstraint(Editor& editor, Index row, const QString& name)
{
  const std::string before = editor.list().constraints[row].name;
  if (name.toStdString() == before) return;
  editor.edit(QObject::tr("rename %1 to %2").arg(nameText(before), nameText(name.toStdString())),
              renamed(editor.list(), row, name.toStdString()));
}

void removeConstraints(Editor& editor, const Rows& rows)
{
  if (rows.empty()) return;
  editor.edit(QObject::tr("delete %1").arg(subjectOf(editor, rows)), removed(editor.list(), rows));
  const Index size = sizeOf(editor.list());
  editor.selectConstraints(size == 0 ? Rows{} : Rows{std::min(rows.front(), size - 1)});
}

void moveConstraints(Editor& editor, const Rows& rows, Index to)
{
  const Index before = static_cast<Index>(std::lower_bound(rows.begin(), rows.end(), to) - rows.begin());
  const Index first = to - before;
  const Rows after = rowsFrom(first, static_cast<Index>(rows.size()));
  if (rows.empty() || rows == after) return;
  editor.edit(QObject::tr("reorder %1").arg(subjectOf(editor, rows)), moved(editor.list(), rows, to));
  editor.selectConstraints(after);
}

void moveConstraintsUp(Editor& editor, const Rows& rows)
{
  if (!rows.empty()) moveConstraints(editor, rows, std::max<Index>(rows.front() - 1, 0));
}

void moveConstraintsDown(Editor& editor, const Rows& rows)
{
  if (!rows.empty()) moveConstraints(editor, rows, std::min(rows.back() + 2, sizeOf(editor.list())));
}

void duplicateConstraints(Editor& editor, const Rows& rows)
{
  if (!rows.empty())
    append(editor, QObject::tr("duplicate %1").arg(subjectOf(editor, rows)), extracted(editor.list(), rows));
}

void mirrorConstraints(Editor& editor, const Rows& rows, const MirrorPlane& plane)
{
  if (!rows.empty())
    append(editor, QObject::tr("mirror %1").arg(subjectOf(editor, rows)),
           mirrored(editor.list(), rows, plane, *editor.model()));
}

void copyConstraints(const Editor& editor, const Rows& rows)
{
  if (rows.empty()) return;
  QGuiApplication::clipboard()->setText(QString::fromStdString(toClipboardText(editor.list(), rows, *editor.model())));
}

void pasteConstraints(Editor& editor)
{
  const ConstraintList list = fromClipboardText(QGuiApplication::clipboard()->text().toStdString());
  const std::size_t count = list.constraints.size();
  append(editor,
         count == 1 ? QObject::tr("paste %1").arg(nameText(list.constraints.front().name))
                    : QObject::tr("paste %n constraints", nullptr, static_cast<int>(count)),
         list);
}

}  // namespace holdfast
