#!/usr/bin/env bash
# Reproduces every figure and table of the paper and writes docs/paper.md, with the pictures of the project's own meshes in
# docs/images/paper and all else in out/paper. Needs Xvfb, no screen.
#   scripts/paper.sh [--small] [WORD...]
# --small: what needs neither fetched models nor minutes. WORD: sections whose titles have one of these words alone. Other
# sections stay as they are. Where models cannot be fetched, the sections that need them stay as they are, too.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. scripts/lib/packages.sh
. scripts/lib/build.sh
. scripts/lib/models.sh

options=()
if [ "${1:-}" != --small ] && ! fetch_models out/paper/models; then
  echo "== Not all models can be fetched (no network?): the sections that need them stay as they are"
  options=(--without-models)
fi
install_packages "${holdfast_packages[@]}"
configure_preset release -DHOLDFAST_BUILD_GUI=ON -DHOLDFAST_WITH_CHOLMOD=ON -DHOLDFAST_BUILD_BENCH=ON
build_preset release holdfast_paper
exec tests/support/with_display.sh build/release/bench/holdfast_paper "${options[@]}" "$@"
