#!/usr/bin/env bash
# A warning of a compiler ends the build where CI is set, and nowhere else.
#   warnings_test.sh WORK-FOLDER
set -euo pipefail
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

# warnings_are_errors WORK-FOLDER: in a build that is configured here.
warnings_are_errors() {
  rm -rf "$1"
  cmake --preset core-only -S "$source" -B "$1" -DHOLDFAST_BUILD_TESTS=OFF >/dev/null
  grep -q -e ' -Werror' "$1/build.ninja"
}

if ! CI=true warnings_are_errors "$1"; then
  echo "error: with CI=true a warning does not end the build" >&2
  exit 1
fi
if (unset CI && warnings_are_errors "$1"); then
  echo "error: without CI a warning ends the build" >&2
  exit 1
fi
