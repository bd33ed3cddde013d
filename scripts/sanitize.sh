#!/usr/bin/env bash
# Runs tests under the sanitizers of the compiler, installing what is missing first (apt). docs/testing.md says more.
#   scripts/sanitize.sh [--threads] [--window] [CTEST-OPTION...]
#     alone                 core and batch, under the address and undefined-behaviour sanitizers
#     --window              widgets, pictures and window, under the same
#     --threads             the worker that deforms in the background, and threads that share a model, under the thread sanitizer
#     --threads --window    the window and its workers, under the thread sanitizer
# Libraries are not built for sanitizers. Those of the window leak (libdbus, drivers of OpenGL), so leaks are looked for
# without it alone; what the thread sanitizer takes wrongly for races of theirs is listed in tests/support/tsan.supp.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. scripts/lib/packages.sh
. scripts/lib/build.sh

preset=asan+ubsan
gui=OFF
while [[ ${1:-} =~ ^--(threads|window)$ ]]; do
  if [ "$1" = --threads ]; then preset=tsan; else gui=ON; fi
  shift
done
[ $gui = OFF ] || preset=$preset-window

install_packages "${holdfast_packages[@]}"
configure_preset "$preset" -DHOLDFAST_BUILD_GUI=$gui -DHOLDFAST_WITH_CHOLMOD=ON -DHOLDFAST_BUILD_TESTS=ON
build_preset "$preset"
echo "== Testing under sanitizers"
exec ctest --preset "$preset" --label-exclude "slow|nightly" "$@"
