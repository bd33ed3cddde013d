#!/usr/bin/env bash
# Builds the core as a shared library, the batch program and their tests where neither VTK nor SuiteSparse nor Qt can be
# found, and runs those tests, the package among them. The build is kept, so that the next time only what changed is compiled.
#   core_only_test.sh BUILD-FOLDER
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
. scripts/lib/build.sh

launcher=()
read -ra launcher <<<"$(ccache_options)"
# Little optimised: compiling is most of what this takes.
cmake --preset core-only --no-warn-unused-cli -B "$1" "${launcher[@]}" -DHOLDFAST_BUILD_TESTS=ON -DBUILD_SHARED_LIBS=ON \
  "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG" \
  -DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON -DCMAKE_DISABLE_FIND_PACKAGE_SuiteSparse=ON -DCMAKE_DISABLE_FIND_PACKAGE_Qt5=ON
cmake --build "$1" --parallel "$(build_jobs)"
ctest --test-dir "$1" --parallel 2 --output-on-failure --no-tests=error --label-exclude nightly
