#!/usr/bin/env bash
# Builds Holdfast and deforms a sample mesh, installing what is missing first (apt).
#   scripts/run.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. scripts/lib/packages.sh
. scripts/lib/build.sh

# The sample without a window: deforms the bracket, says where the results are and what came out.
# Ends with the exit code of the program.
run_headless() {
  local status=0
  mkdir -p out
  echo "== Deforming data/bracket.obj"
  # The picture needs an X server: the one that is there, or one of its own.
  local display=()
  [ -n "${DISPLAY:-}" ] || display=(tests/support/with_display.sh)
  "${display[@]}" build/release/app/holdfast-batch deform data/bracket.obj --constraints data/bracket.constraints.json \
    --out out/bracket_deformed.obj --report out/bracket_report.json --fields out/bracket_fields.vtp --snapshot out/bracket.png || status=$?
  # 4: some constraints contradict others; everything was written all the same.
  [ "$status" -eq 0 ] || [ "$status" -eq 4 ] || return "$status"
  cmake -D REPORT=out/bracket_report.json -P scripts/lib/summarize_report.cmake
  echo "== Written"
  printf '  %-28s %s\n' out/bracket_deformed.obj "the deformed mesh" \
    out/bracket_report.json "what became of each constraint" \
    out/bracket_fields.vtp "residuals and displacements, for ParaView and the like" \
    out/bracket.png "a picture of it"
  return "$status"
}

install_packages "${holdfast_packages[@]}"
configure_preset release -DHOLDFAST_BUILD_GUI=ON -DHOLDFAST_WITH_CHOLMOD=ON -DHOLDFAST_BUILD_TESTS=ON
build_preset release app/holdfast-batch
run_headless
