#!/usr/bin/env bash
# Fails with file:line where a layer includes a library that its link targets must not reach. check_rooms.sh sees the rest.
#   check_layers.sh ROOT        ROOT is the folder that holds core, widgets and app
set -u
cd "$1" || exit 2

vtk='[<"]([^>"]*/)?(vtk|QVTK)[A-Za-z0-9_]*\.h[>"]'
qt='([<"](Qt[A-Za-z0-9]*/)?Q[A-Za-z0-9]+[>"]|[<"]Qt[A-Za-z0-9]*/q[a-z0-9_]+\.h[>"]|<q[a-z0-9_]+\.h>)'
failures=0

# check_layer FOLDER FORBIDDEN-INCLUDE...
check_layer() {
  local folder=$1 forbidden
  shift
  if [ -z "$(find "$folder" -name '*.cpp' -print -quit 2>/dev/null)" ]; then
    echo "$folder: no sources here; tests/layering/check_layers.sh names the folders of the layers"
    failures=1
    return
  fi
  for forbidden in "$@"; do
    grep -rnE --include='*.h' --include='*.cpp' "^[[:space:]]*#[[:space:]]*include[[:space:]]*$forbidden" "$folder" &&
      failures=1
  done
}

check_layer core "$vtk" "$qt"
check_layer widgets "$qt"
check_layer app/batch "$qt"
exit "$failures"
