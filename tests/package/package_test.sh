#!/usr/bin/env bash
# Installs a build into a fresh prefix, builds the consumer project against it and runs it; first with the core alone,
# for which no other layer's dependencies may be asked, then with every layer that was built.
#   package_test.sh BUILD-FOLDER WORK-FOLDER LAYER...
set -euo pipefail
build=$1
work=$2
shift 2
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

# consume NAME LAYERS [CMAKE-OPTION...]
consume() {
  local name=$1 layers=$2
  shift 2
  cmake --no-warn-unused-cli -G Ninja -S "$source/tests/package/consumer" -B "$work/$name" \
    -DCMAKE_PREFIX_PATH="$work/prefix" -DLAYERS="$layers" "$@" &&
    cmake --build "$work/$name" &&
    run_all "$work/$name"/use_*
}

run_all() {
  local program
  for program in "$@"; do
    "$program" || return
  done
}

rm -rf "$work"
cmake --install "$build" --prefix "$work/prefix"
if grep -rnF -e "$source/core/" -e "$source/widgets/" -e "$build/core" -e "$build/widgets" -e holdfast_warnings \
  "$work/prefix" --include="*.cmake"; then
  echo "error: the installed package refers to the source tree it was built from" >&2
  exit 1
fi
consume core core -DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON
consume all "$(IFS=';' && echo "$*")"
if consume absent "core;nonesuch" >"$work/absent.log" 2>&1 || ! grep -q 'nonesuch' "$work/absent.log"; then
  echo "error: a layer that does not exist was found, or not named; see $work/absent.log" >&2
  exit 1
fi
