#!/usr/bin/env bash
# Builds the benchmarks and runs them, installing what is missing first (apt). docs/performance.md explains the tables.
#   scripts/bench.sh [MESH...] [OPTION-OF-GOOGLE-BENCHMARK...]      for example: scripts/bench.sh 35 --benchmark_filter=edits
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. scripts/lib/packages.sh
. scripts/lib/build.sh

install_packages "${holdfast_packages[@]}"
configure_preset release -DHOLDFAST_BUILD_GUI=ON -DHOLDFAST_WITH_CHOLMOD=ON -DHOLDFAST_BUILD_BENCH=ON
build_preset release holdfast_bench
exec build/release/bench/holdfast_bench "$@"
