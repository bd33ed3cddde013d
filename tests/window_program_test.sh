#!/usr/bin/env bash
# What the window's program does without a display, and its tests on a Wayland compositor, with an X server beside it and
# without.
#   window_program_test.sh PROGRAM WINDOW_TESTS
# Ends with 77 where no compositor is installed.
set -u
program=$1
tests=$2
support=$(dirname "${BASH_SOURCE[0]}")/support
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0

# expect WHAT WANTED GOT
expect() {
  [ "$2" = "$3" ] && return
  echo "$1: wanted $2, got $3"
  failures=$((failures + 1))
}

for environment in "-u DISPLAY" "DISPLAY=:9999" "QT_QPA_PLATFORM=offscreen" "WAYLAND_DISPLAY=absent"; do
  env -u DISPLAY -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM $environment "$program" 2>"$folder/said"
  expect "exit code with $environment" 3 $?
  expect "lines of others with $environment" 0 "$(grep -vc '^holdfast: ' "$folder/said")"
  expect "ways out with $environment" 1 "$(grep -c 'holdfast-batch works without a window' "$folder/said")"
done

# Pictures in the window, and one in a file.
chosen=ColorsOfBar.EveryMapDrawsItsOwnColours:DocumentExportsTest.APictureHasTheLegendOfTheWindowAtItsScale
# under WHERE LAUNCHER...
under() {
  local where=$1
  shift
  "$@" "$tests" "--gtest_filter=$chosen" >"$folder/out" 2>"$folder/said"
  local code=$?
  [ "$code" -eq 77 ] && cat "$folder/said" && exit $((failures > 0 ? 1 : 77))
  expect "exit code $where" 0 "$code"
  expect "what it prints to stderr $where" "" "$(cat "$folder/said")"
  [ "$code" -eq 0 ] || cat "$folder/out"
}
under "on Wayland" env -u DISPLAY "$support/with_wayland.sh"
under "on Wayland beside X" "$support/with_display.sh" "$support/with_wayland.sh"
[ "$failures" -eq 0 ]
