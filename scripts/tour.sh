#!/usr/bin/env bash
# Drives the window through everything that it does and writes a picture of each step. Needs Xvfb, no screen.
#   scripts/tour.sh [FOLDER]      FOLDER: out/tour where it is not given
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. scripts/lib/packages.sh
. scripts/lib/build.sh

folder=${1:-out/tour}
install_packages "${holdfast_packages[@]}"
configure_preset release -DHOLDFAST_BUILD_GUI=ON -DHOLDFAST_WITH_CHOLMOD=ON -DHOLDFAST_BUILD_TESTS=ON
build_preset release holdfast_tour

mkdir -p "$folder"
rm -f "$folder"/[0-9]*_*.png
# The large window of the tour takes the whole screen.
export HOLDFAST_SCREEN=2560x1600
tests/support/with_display.sh build/release/tests/holdfast_tour "$folder"
QT_SCALE_FACTOR=2 tests/support/with_display.sh build/release/tests/holdfast_tour "$folder" glance
HOLDFAST_SCREEN=3840x2160 QT_SCALE_FACTOR=2 tests/support/with_display.sh build/release/tests/holdfast_tour "$folder" sizes
echo "== Written: $(find "$folder" -name '*.png' | wc -l) pictures in $folder"
