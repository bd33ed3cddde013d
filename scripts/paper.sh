#!/usr/bin/env bash
# Reproduces every figure and table of the paper and writes docs/paper.md. Pictures of the project's own meshes go to
# docs/images/paper, all else to out/paper. Needs Xvfb, no screen.
#   scripts/paper.sh [--small] [WORD...]
# --small: what needs neither fetched models nor minutes. WORD: only sections whose titles have one of these words. All
# others stay as they are, and so do those that need what cannot be fetched: models, the headers of CGAL.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. scripts/lib/packages.sh
. scripts/lib/build.sh
. scripts/lib/models.sh

options=()
if [ "${1:-}" != --small ] && ! { fetch_models out/paper/models && fetch_cgal out/paper/cgal; }; then
  echo "== Not all can be fetched (no network?): the sections that need models or CGAL stay as they are"
  options=(--without-models)
fi
install_packages "${holdfast_packages[@]}"
configure_preset release -DHOLDFAST_BUILD_GUI=ON -DHOLDFAST_WITH_CHOLMOD=ON -DHOLDFAST_BUILD_BENCH=ON \
  -DCMAKE_INCLUDE_PATH="$PWD/out/paper/cgal"
build_preset release holdfast_paper
exec tests/support/with_display.sh build/release/bench/holdfast_paper "${options[@]}" "$@"
