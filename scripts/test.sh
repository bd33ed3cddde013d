#!/usr/bin/env bash
# Builds Holdfast and runs its test suite, installing what is missing first (apt). What takes too long for every change,
# label `nightly`, is left out where nothing is asked for. scripts/nightly.sh has it, and benchmarks, experiments and each
# header compiled alone.
#   scripts/test.sh [CTEST-OPTION...]      for example: scripts/test.sh -R layering, scripts/test.sh -LE 'nightly|slow'
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. scripts/lib/packages.sh
. scripts/lib/build.sh

install_packages "${holdfast_packages[@]}"
configure_preset release -DHOLDFAST_BUILD_GUI=ON -DHOLDFAST_WITH_CHOLMOD=ON -DHOLDFAST_BUILD_TESTS=ON -DHOLDFAST_BUILD_BENCH=OFF
build_preset release
echo "== Testing"
[ $# -gt 0 ] || set -- --label-exclude nightly
exec ctest --preset release "$@"
