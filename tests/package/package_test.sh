#!/usr/bin/env bash
# Installs a build into a fresh prefix and uses it as others do: the README's project deforms the bundled bracket with the
# core alone, and a second project with the widgets, if they were built. Then the controls: what must not pass.
#   package_test.sh BUILD-FOLDER WORK-FOLDER LAYER...
set -euo pipefail
build=$1
work=$2
shift 2
layers=" $* "
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
prefix=$work/prefix

fail() {
  echo "error: $*" >&2
  exit 1
}

# readme_block LANGUAGE: what the README prints in that language.
readme_block() {
  sed -n "/^\`\`\`$1\$/,/^\`\`\`\$/ { /^\`\`\`/d; p }" "$source/README.md"
}

# build_project FOLDER [CMAKE-OPTION...]
build_project() {
  local folder=$1
  shift
  cmake -G Ninja -S "$folder" -B "$folder/build" -DCMAKE_PREFIX_PATH="$prefix" "$@" && cmake --build "$folder/build"
}

# expect_refused WORDS COMMAND...: the command fails, and says these words.
expect_refused() {
  local words=$1
  shift
  if "$@" >"$work/refused.log" 2>&1; then fail "this must fail: $*"; fi
  tr -s ' \n' ' ' <"$work/refused.log" | grep -qF "$words" || fail "no word of '$words' from: $*; see $work/refused.log"
}

# bracket_in FOLDER [CONSTRAINTS]: the bundled bracket and constraints for it.
bracket_in() {
  mkdir -p "$1"
  cp "$source/data/bracket.obj" "$1/"
  cp "${2:-$source/data/bracket.constraints.json}" "$1/bracket.constraints.json"
}

# is_deformed MESH: the bracket as its constraints ask. The first one that is pinned to a vertex tells it from others
# without the library, and holdfast-batch writes the same file.
is_deformed() {
  [ "$(grep '^v ' "$1" | sed -n 3142p)" = "v 15.1786 9.365903 50.37766" ] && cmp "$work/expected.obj" "$1"
}

rm -rf "$work"
cmake --install "$build" --prefix "$prefix"
if grep -rnF -e "$source/core/" -e "$source/widgets/" -e "$build/core" -e "$build/widgets" -e holdfast_warnings \
  "$prefix" --include="*.cmake"; then
  fail "the installed package refers to the source tree it was built from"
fi
# The pages lie beside what they link to.
for file in README.md CHANGELOG.md CONTRIBUTING.md LICENSE docs/library.md data/README.md examples/deform_files.cpp; do
  [ -f "$prefix/share/holdfast/$file" ] || fail "the installed pages lack $file"
done
"$prefix/bin/holdfast-batch" deform "$source/data/bracket.obj" --quiet \
  --constraints "$source/data/bracket.constraints.json" --out "$work/expected.obj"
echo '{"format": "holdfast-constraints", "version": 1, "constraints": []}' >"$work/nothing.json"
bracket_in "$work/bracket"
bracket_in "$work/rest" "$work/nothing.json"

mkdir "$work/mine"
readme_block cmake >"$work/mine/CMakeLists.txt"
readme_block cpp >"$work/mine/mine.cpp"
cmp "$work/mine/mine.cpp" "$source/examples/deform_files.cpp" || fail "the README prints another program than examples/deform_files.cpp"
# Nothing of VTK may be asked for.
build_project "$work/mine" -DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON
(cd "$work/bracket" && "$work/mine/build/mine")
is_deformed "$work/bracket/deformed.obj" || fail "the README's program does not write the deformed bracket"
# Controls: another result, and no input.
(cd "$work/rest" && "$work/mine/build/mine")
if is_deformed "$work/rest/deformed.obj"; then fail "the bracket at rest passes for the deformed one"; fi
expect_refused "bracket.obj" "$work/mine/build/mine"

# Every installed header needs nothing but what is installed.
headers_alone() {
  local component=$1
  mkdir -p "$work/headers_$component"
  {
    printf 'cmake_minimum_required(VERSION 3.25)\nproject(headers LANGUAGES C CXX)\n'
    printf 'find_package(holdfast REQUIRED COMPONENTS %s)\nadd_library(headers OBJECT all.cpp)\n' "$component"
    printf 'target_link_libraries(headers PRIVATE holdfast::%s)\n' "$component"
  } >"$work/headers_$component/CMakeLists.txt"
  (cd "$prefix/include" && find holdfast -name '*.h' | sort) | grep "$2" "^holdfast/widgets/" |
    sed 's/.*/#include <&>/' >"$work/headers_$component/all.cpp"
  build_project "$work/headers_$component"
}
headers_alone core -v

# The examples, as a project of its own.
cp -r "$source/examples" "$work/examples"
build_project "$work/examples"
examples=$work/examples/build
"$examples/deform_matrices" >"$work/matrices.txt" || fail "deform_matrices does not meet its constraints"
# The tip is the midpoint of the first two of the three vertices at the end.
awk 'NR > 1 { for (k = 1; k <= 3; ++k) at[NR, k] = $k }
  END { exit !((at[2, 1] + at[3, 1]) / 2 == 9 && (at[2, 3] + at[3, 3]) / 2 == 3) }' "$work/matrices.txt" ||
  fail "deform_matrices misses its target: $(cat "$work/matrices.txt")"
"$examples/drag_in_a_loop" "$work/bracket/bracket.obj" "$work/bracket/bracket.constraints.json" "bore rim east" >"$work/frames.txt" ||
  fail "drag_in_a_loop fails"
[ "$(grep -c '^frame' "$work/frames.txt")" -eq 5 ] || fail "drag_in_a_loop shows other frames than five"
expect_refused "nonesuch" "$examples/drag_in_a_loop" "$work/bracket/bracket.obj" "$work/bracket/bracket.constraints.json" nonesuch
status=0
"$examples/read_conflicts" "$source/data/plate_unsymmetric.off" "$source/data/plate_unsymmetric.conflict.constraints.json" \
  >"$work/conflicts.txt" || status=$?
{ [ "$status" -eq 4 ] && grep -q "; disable " "$work/conflicts.txt"; } || fail "read_conflicts finds no conflict"
"$examples/read_conflicts" "$source/data/bracket.obj" "$source/data/bracket.constraints.json" || fail "read_conflicts finds one too many"

# refuse_package WORDS LANGUAGES ARGUMENTS: what find_package(holdfast ARGUMENTS) refuses with these words.
refuse_package() {
  printf 'cmake_minimum_required(VERSION 3.25)\nproject(refused %s)\nfind_package(holdfast %s)\n' \
    "$2" "$3" >"$work/CMakeLists.txt"
  rm -rf "$work/build"
  expect_refused "$1" build_project "$work"
}

refuse_package "This holdfast has no nonesuch" CXX "REQUIRED COMPONENTS core nonesuch"
# Each major version is asked for by its number. README asks for the present one.
for version in 0.1 2.0; do
  refuse_package "compatible with requested version \"$version\"" CXX "$version REQUIRED"
done
case $layers in *" widgets "*)
  refuse_package "project(... LANGUAGES C CXX)" CXX "REQUIRED COMPONENTS widgets"
  headers_alone widgets -e
  "$examples/vtk_pipeline" "$source/data/bracket.obj" "$source/data/bracket.constraints.json" "$work/pipeline.vtp" ||
    fail "vtk_pipeline does not deform the bracket"
  grep -q 'Name="constraint_residual"' "$work/pipeline.vtp" || fail "vtk_pipeline writes no fields"
  expect_refused "" "$examples/vtk_pipeline" "$source/data/bracket.obj" "$work/missing.json" "$work/none.vtp"
  "$source/tests/support/with_display.sh" "$examples/drag_point" "$source/data/bracket.obj" "$work/dragged.obj" \
    "$source/examples/drag_point.recording" || fail "drag_point does not play its recording"
  cp -r "$source/tests/package/widgets_consumer" "$work/widgets"
  build_project "$work/widgets"
  (cd "$work/bracket" && "$work/widgets/build/use_widgets") || fail "the project with widgets does not write the deformed bracket"
  # Control.
  if (cd "$work/rest" && "$work/widgets/build/use_widgets"); then fail "the bracket at rest passes for the deformed one"; fi
esac
