#!/usr/bin/env bash
# What the window's program says and how it ends where there is nothing to draw on.
#   window_program_test.sh PROGRAM
set -u
program=$1
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

[ "$failures" -eq 0 ]
