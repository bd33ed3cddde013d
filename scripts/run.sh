#!/usr/bin/env bash
# Builds Holdfast, installing what is missing first (apt), and opens its window on the bundled bracket with its measured
# points. Where there is no display it deforms the same session without a window.
#   scripts/run.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. scripts/lib/packages.sh
. scripts/lib/build.sh

session=data/bracket.holdfast

has_display() {
  [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]
}

# The session without a window: deforms the bracket, says what came out and where it is.
# Ends with the exit code of the program.
run_headless() {
  local status=0
  mkdir -p out
  echo "== No display here: deforming the bracket of $session without a window"
  # The picture needs an X server, here one of its own.
  tests/support/with_display.sh build/release/app/holdfast-batch deform data/bracket.obj --constraints "$session" \
    --out out/bracket_deformed.obj --report out/bracket_report.json --fields out/bracket_fields.vtp --snapshot out/bracket.png || status=$?
  # 4: some constraints contradict others; everything was written all the same.
  [ "$status" -eq 0 ] || [ "$status" -eq 4 ] || return "$status"
  cmake -D REPORT=out/bracket_report.json -P scripts/lib/summarize_report.cmake
  echo "== Written"
  printf '  %-28s %s\n' out/bracket.png "the picture" \
    out/bracket_report.json "the report: what became of each constraint" \
    out/bracket_deformed.obj "the deformed mesh" \
    out/bracket_fields.vtp "residuals and displacements, for ParaView and the like"
  return "$status"
}

install_packages "${holdfast_packages[@]}"
configure_preset release -DHOLDFAST_BUILD_GUI=ON -DHOLDFAST_WITH_CHOLMOD=ON -DHOLDFAST_BUILD_TESTS=ON
if has_display; then
  build_preset release app/holdfast
  echo "== Opening $session"
  status=0
  build/release/app/holdfast "$session" || status=$?
  # 3: the display is none that can be drawn on.
  [ "$status" -eq 3 ] || exit "$status"
fi
build_preset release app/holdfast-batch
run_headless
