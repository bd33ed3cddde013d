#!/usr/bin/env bash
# Makes the pictures of the documentation again: the same bytes on every run with the same Mesa. Needs Xvfb, no window.
#   scripts/pictures.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. scripts/lib/build.sh

configure_preset release -DHOLDFAST_BUILD_GUI=ON
build_preset release app/holdfast-batch
tests/support/with_display.sh build/release/app/holdfast-batch deform data/bracket.obj \
  --constraints data/bracket.constraints.json --snapshot docs/images/bracket.png --color-by displacement --size 1200x800
