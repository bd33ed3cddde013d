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
  for folder in core/holdfast/mesh widgets/view/holdfast/view widgets/qt/holdfast/widgets app/batch; do
    mkdir -p "$tree/$folder"
    printf '%s\n' '#include <vector>' '#include <Eigen/QR>' '#include "quaternion.h"' '#include <holdfast/mesh/mesh.h>' \
      '// #include <QWidget>' >"$tree/$folder/clean.cpp"
  done
  echo '#include <vtkPolyData.h>' >"$tree/widgets/view/holdfast/view/actor.cpp"
  touch "$tree/core/holdfast/mesh/weld.h"
  printf '%s\n' '// Of vertices.' '#include "holdfast/mesh/weld.h"' '#include <vector>' >"$tree/core/holdfast/mesh/weld.cpp"
  echo '#include <holdfast/view/actor.h>' >"$tree/app/batch/picture.cpp"
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
expect_clean check_words.sh
expect_clean check_own_headers.sh

for leak in '#include <vtkPolyData.h>' '#  include "vtkNew.h"' '#include <QVTKOpenGLNativeWidget.h>' '#include <QWidget>' \
  '#include <QtCore/QObject>' '#include <qobject.h>' '#include "QtWidgets/qwidget.h"' '#include "QWidget"' \
  '#include <holdfast/view/actor.h>' '#include "../../view/actor.h"' '#include <holdfast/widgets/table.h>'; do
  expect_found check_layers.sh core/holdfast/mesh/leak.h "$leak"
done
for folder in widgets/view/holdfast/view app/batch; do
  for leak in '#include <QWidget>' '#include <holdfast/widgets/table.h>'; do
    expect_found check_layers.sh "$folder/leak.cpp" "$leak"
  done
done
expect_found check_layers.sh widgets/qt/holdfast/widgets/leak.cpp '#include "app/holdfast/main.h"'
for word in TO''DO FIX''ME; do
  expect_found check_words.sh core/leak.txt "later: $word, and so on"
done
for folder in core/holdfast/mesh widgets/qt/holdfast/widgets; do
  touch "$tree/$folder/leak.h"
  for leak in '#include <vector>' "#include <holdfast/${folder#*/holdfast/}/leak.h>" '#include "holdfast/mesh/weld.h"'; do
    expect_found check_own_headers.sh "$folder/leak.cpp" "$leak"
  done
  rm "$tree/$folder/leak.h"
done

rm -r "$tree/core/holdfast"
if "$here/check_layers.sh" "$tree" >/dev/null; then
  echo "check_layers.sh passes a layer without sources"
  failures=1
fi
exit "$failures"
