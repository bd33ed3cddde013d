#!/usr/bin/env bash
# Makes the pictures of the documentation again: the same bytes on every run with the same Mesa, but for the milliseconds
# in those of the window. Needs Xvfb, no screen.
#   scripts/pictures.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. scripts/lib/build.sh

# draw NAME MESH CONSTRAINTS COLOURS SIZE: deforms a mesh of data/ and draws docs/images/NAME.png.
draw() {
  local status=0
  tests/support/with_display.sh build/release/app/holdfast-batch deform "data/$2" --constraints "data/$3.constraints.json" \
    --snapshot "docs/images/$1.png" --color-by "$4" --size "$5" || status=$?
  # 4: conflicts are what some of the pictures show.
  [ "$status" -eq 0 ] || [ "$status" -eq 4 ] || return "$status"
}

# The window at work: docs/images/window.png and others.
draw_window() {
  local folder picture
  folder=$(mktemp -d)
  tests/support/with_display.sh build/release/tests/holdfast_tour "$folder" documents
  for picture in "$folder"/*.png; do
    mv "$picture" "docs/images/${picture##*/[0-9][0-9]_}"
  done
  rmdir "$folder"
}

# The window of the example, as the test of its recording sees it.
draw_example() {
  tests/support/with_display.sh build/release/tests/holdfast_interaction_tests --gtest_filter=DragPointExample.IsPicturedAtWork
  cp build/release/tests/drag_point.png docs/images/drag_point.png
}

configure_preset release -DHOLDFAST_BUILD_GUI=ON -DHOLDFAST_BUILD_TESTS=ON
build_preset release app/holdfast-batch
build_preset release holdfast_tour
build_preset release widget_pictures
build_preset release holdfast_interaction_tests
draw bracket bracket.obj bracket displacement 1200x800
draw twist bar.obj bar.twist_720 angle 720x640
draw two_handles plate_unsymmetric.off plate_unsymmetric.two_handles angle 720x640
draw three_handles plate_unsymmetric.off plate_unsymmetric.three_handles angle 720x640
draw rigid_eyes head.ply head.rigid_eyes angle 720x640
draw conflicts plate_unsymmetric.off plate_unsymmetric.conflict displacement 720x640
draw forces bracket.obj bracket force 720x640
draw kinds_slide bracket.obj bracket.slide displacement 900x640
draw kinds_mirror bar.obj bar.mirror displacement 720x640
draw kinds_scan bracket.obj bracket.scan displacement 720x640
draw kinds_within plate_unsymmetric.off plate_unsymmetric.within displacement 900x560
draw kinds_joined two_parts.obj two_parts.joined displacement 720x560
draw_window
tests/support/with_display.sh build/release/examples/widget_pictures data docs/images
draw_example
