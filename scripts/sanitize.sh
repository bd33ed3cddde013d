#!/usr/bin/env bash
# Builds the core under the address and undefined-behaviour sanitizers and runs its tests.
#   scripts/sanitize.sh [CTEST-OPTION...]
# Without the view layer: VTK itself is not built for sanitizers.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. scripts/lib/packages.sh
. scripts/lib/build.sh

install_packages "${holdfast_packages[@]}"
configure_preset asan+ubsan -DHOLDFAST_BUILD_GUI=OFF -DHOLDFAST_WITH_CHOLMOD=ON -DHOLDFAST_BUILD_TESTS=ON
build_preset asan+ubsan
echo "== Testing under sanitizers"
exec ctest --preset asan+ubsan --label-exclude "slow|large" "$@"
