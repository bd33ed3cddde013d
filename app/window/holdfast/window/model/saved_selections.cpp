#include "holdfast/window/model/saved_selections.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <holdfast/window/text/constraint_text.h>
#include <holdfast/words/error.h>

namespace holdfast {
namespace {

bool isTaken(const std::vector<SavedSelection>& selections, const std::string& name)
{
  return std::ranges::count(selections, name, &SavedSelection::name) != 0;
}

}  // namespace

void saveSelection(Editor& editor)
{
  std::vector<SavedSelection> selections = editor.annotations().selections;
  std::size_t number = 1;
  while (isTaken(selections, fmt::format("selection {}", number))) ++number;
  selections.push_back({fmt::format("selection {}", number), editor.selection()});
  const QString name = nameText(selections.back().name);
  editor.setSavedSelections(QObject::tr("save %1").arg(name), std::move(selections));
}

void renameSavedSelection(Editor& editor, Index place, const QString& name)
{
  std::vector<SavedSelection> selections = editor.annotations().selections;
  const std::string before = std::exchange(selections[place].name, "");
  const std::string after = name.trimmed().toStdString();
  if (after == before) return;
  if (after.empty()) throw InputError({}, "the name is empty; give one");
  if (isTaken(selections, after)) throw InputError({}, "another selection has this name; give another one");
  selections[place].name = after;
  editor.setSavedSelections(QObject::tr("rename %1 to %2").arg(nameText(before), nameText(after)),
                            std::move(selections));
}

void removeSavedSelections(Editor& editor, const Rows& places)
{
  if (places.empty()) return;
  std::vector<SavedSelection> selections = editor.annotations().selections;
  const QString subject =
      places.size() == 1 ? nameText(selections[places.front()].name) : QObject::tr("%1 selections").arg(places.size());
  for (auto place = places.rbegin(); place != places.rend(); ++place) selections.erase(selections.begin() + *place);
  editor.setSavedSelections(QObject::tr("delete %1").arg(subject), std::move(selections));
}

void selectSaved(Editor& editor, Index place)
{
  const SavedSelection& saved = editor.annotations().selections[place];
  std::vector<Index> vertices =
      editor.mesh().selector->select(saved.select, {editor.mesh().path.string(), 0, saved.name});
  const bool isShape = !std::holds_alternative<VertexIds>(saved.select.what);
  editor.selectVertices(std::move(vertices), isShape ? std::optional(saved.select) : std::nullopt);
}

}  // namespace holdfast
