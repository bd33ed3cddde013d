#!/usr/bin/env bash
# The controls of the checks beside it: each leak planted in a tree of sources is found, alone, at its line, and a tree
# without leaks passes.
#   checks_test.sh
set -u
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failures=0

# Sources that every layer may hold, leaks nowhere.
plant_clean_tree() {
  local folder
  for folder in core/holdfast/mesh core/holdfast/numbers widgets/holdfast/widgets/scene app/window/holdfast/window/panels app/batch; do
    mkdir -p "$tree/$folder"
    printf '%s\n' '#include <vector>' '#include <Eigen/QR>' '#include "quaternion.h"' '#include <holdfast/mesh/mesh.h>' \
      '// #include <QWidget>' >"$tree/$folder/clean.cpp"
  done
  sed -i '/mesh.h/d' "$tree/core/holdfast/numbers/clean.cpp"
  echo '#include <vtkPolyData.h>' >"$tree/widgets/holdfast/widgets/scene/actor.cpp"
  touch "$tree/core/holdfast/mesh/weld.h"
  printf '%s\n' '// Of vertices.' '#include "holdfast/mesh/weld.h"' '#include <vector>' >"$tree/core/holdfast/mesh/weld.cpp"
  echo '#include <holdfast/widgets/scene/actor.h>' >"$tree/app/batch/picture.cpp"
  mkdir "$tree/docs"
  {
    printf '| `%s` | what is in it |\n' app/batch window/panels widgets/scene core/mesh core/numbers
    printf '```mermaid\n%s\n```\n' "$("$here/../../scripts/rooms.sh" "$tree")"
  } >"$tree/docs/rooms.md"
  printf '| not used | instead |\n|---|---|\n| `Oldie`, `struct Thing` | `Newcomer` |\n' >"$tree/docs/glossary.md"
}

# expect_found CHECK FILE LINE-OF-CODE: the check passes without the line, and with it names the file and the line.
expect_found() {
  local check=$1 file=$2 line=$3 found status
  printf '\n%s\n' "$line" >"$tree/$file"
  found=$("$here/$check" "$tree")
  status=$?
  rm "$tree/$file"
  if [ $status -eq 0 ] || [ "${found#./}" != "$file:2:$line" ]; then
    echo "$check on $file with '$line': exit code $status, found '$found'"
    failures=1
  fi
}

# expect_clean CHECK
expect_clean() {
  local found
  if ! found=$("$here/$1" "$tree"); then
    echo "$1 finds a leak where there is none: $found"
    failures=1
  fi
}

plant_clean_tree
expect_clean check_layers.sh
expect_clean check_rooms.sh
expect_clean check_words.sh
expect_clean check_own_headers.sh
echo '  holdfast/mesh/mesh.h' | tee "$tree/core/CMakeLists.txt" >"$tree/widgets/CMakeLists.txt"
expect_clean check_installed_headers.sh
printf '%s\n' 'enum class Kind { Thing };  // an Oldie' 'const Newcomer text("Oldie");' >"$tree/core/holdfast/mesh/terms.cpp"
expect_clean check_terms.sh
recipe=$'## A mesh\n\nFollow `weld.h`. Then go on.\n\n- `core/holdfast/mesh/weld.cpp`: welds\n'
echo "$recipe" >"$tree/docs/recipes.md"
expect_clean check_recipes.sh
for wrong in "${recipe/weld.cpp/solid.cpp}" "${recipe/weld.h/mesh.h}" "$recipe- \`core/holdfast/mesh/weld.h\`: too many" ""; do
  echo "$wrong" >"$tree/docs/recipes.md"
  if "$here/check_recipes.sh" "$tree" >/dev/null; then
    echo "check_recipes.sh passes this page: $wrong"
    failures=1
  fi
done

for leak in '#include <vtkPolyData.h>' '#  include "vtkNew.h"' '#include <QVTKOpenGLNativeWidget.h>' '#include <QWidget>' \
  '#include <QtCore/QObject>' '#include <qobject.h>' '#include "QtWidgets/qwidget.h"' '#include "QWidget"'; do
  expect_found check_layers.sh core/holdfast/mesh/leak.h "$leak"
done
for folder in widgets/holdfast/widgets/scene app/batch; do
  expect_found check_layers.sh "$folder/leak.cpp" '#include <QWidget>'
done

# expect_room_error WORDS: the rooms are not those of the page, and it says so.
expect_room_error() {
  local found status
  found=$("$here/check_rooms.sh" "$tree")
  status=$?
  if [ $status -eq 0 ] || [[ $found != *"$1"* ]]; then
    echo "check_rooms.sh: exit code $status, found '$found' in the place of '$1'"
    failures=1
  fi
}

leak=core/holdfast/numbers/leak.h
echo '#include <holdfast/mesh/mesh.h>' >"$tree/$leak"
expect_room_error "$leak:1: core/numbers includes core/mesh, which does not stand below it"
rm "$tree/$leak"
mkdir "$tree/core/holdfast/attic"
expect_room_error "no row for the room core/attic"
rmdir "$tree/core/holdfast/attic"
sed -i.whole '/core_mesh --> core_numbers/d; s/`core.numbers`/`core\/cellar`/' "$tree/docs/rooms.md"
expect_room_error "no folder for the room core/cellar"
mv "$tree/docs/rooms.md.whole" "$tree/docs/rooms.md"
echo '#include <holdfast/numbers/types.h>' >"$tree/core/holdfast/mesh/new.h"
expect_room_error "the picture is not that of scripts/rooms.sh"
rm "$tree/core/holdfast/mesh/new.h"
for leak in 'Oldie a;' 'f(Oldie{});' 'struct Thing {'; do
  expect_found check_terms.sh core/holdfast/mesh/leak.h "$leak"
done
touch "$tree/core/holdfast/mesh/Oldie.h"
if "$here/check_terms.sh" "$tree" >/dev/null; then
  echo "check_terms.sh passes a file of a name that is not used"
  failures=1
fi
rm "$tree/core/holdfast/mesh/Oldie.h"
for word in TO''DO FIX''ME; do
  expect_found check_words.sh core/leak.txt "later: $word, and so on"
done
for folder in core/holdfast/mesh app/window/holdfast/window/panels; do
  touch "$tree/$folder/leak.h"
  for leak in '#include <vector>' "#include <holdfast/${folder#*/holdfast/}/leak.h>" '#include "holdfast/mesh/weld.h"'; do
    expect_found check_own_headers.sh "$folder/leak.cpp" "$leak"
  done
  rm "$tree/$folder/leak.h"
done

for header in core/holdfast/mesh/mesh.h widgets/holdfast/widgets/scene/leak.h; do
  expect_found check_installed_headers.sh "$header" '#include <holdfast/mesh/weld.h>'
done

rm -r "$tree/core/holdfast"
if "$here/check_layers.sh" "$tree" >/dev/null; then
  echo "check_layers.sh passes a layer without sources"
  failures=1
fi
exit "$failures"
