#!/usr/bin/env bash
# Builds the benchmarks and runs them, installing what is missing first (apt). docs/performance.md explains the tables.
#   scripts/bench.sh [window] [MESH...] [OPTION-OF-GOOGLE-BENCHMARK...]      for example: scripts/bench.sh 35 --benchmark_filter=edits
# With `window` those of the window.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. scripts/lib/packages.sh
. scripts/lib/build.sh

install_packages "${holdfast_packages[@]}"
configure_preset release -DHOLDFAST_BUILD_GUI=ON -DHOLDFAST_WITH_CHOLMOD=ON -DHOLDFAST_BUILD_BENCH=ON
program=holdfast_bench
launcher=()
if [ "${1:-}" = window ]; then
  shift
  program=holdfast_window_bench
  launcher=(tests/support/with_display.sh)
fi
build_preset release "$program"
exec "${launcher[@]}" "build/release/bench/$program" "$@"
