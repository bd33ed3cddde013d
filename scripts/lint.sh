#!/usr/bin/env bash
# Checks the layout and the names of all sources: clang-format and clang-tidy, version 14 as in Debian 12.
#   scripts/lint.sh [--format] [FILE...]     --format: the layout alone, which needs no compile database
# Without files: all of them. clang-tidy reads how each is compiled from build/debug, where each is compiled by itself.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. scripts/lib/build.sh

checks=all
if [ "${1:-}" = --format ]; then
  checks=format
  shift
fi
files=("$@")
if [ ${#files[@]} -eq 0 ]; then
  mapfile -t files < <(find core widgets app examples tests bench -name '*.h' -o -name '*.cpp' 2>/dev/null | sort)
fi

# Other versions lay out differently. 77 is CTest's word for a test that was skipped.
require() {
  if ! command -v "$1" >/dev/null; then
    echo "skipped: $1 is not installed (apt-get install $1, version 14)" >&2
  elif ! "$1" --version | grep -q 'version 14\.'; then
    echo "skipped: $1 is of another version than 14" >&2
  else
    return 0
  fi
  exit 77
}

require clang-format
echo "== Layout of ${#files[@]} files"
clang-format --dry-run -Werror "${files[@]}"
[ "$checks" = all ] || exit 0

require clang-tidy
database=build/debug
[ -f "$database/compile_commands.json" ] ||
  configure_preset debug -DHOLDFAST_BUILD_GUI=ON -DHOLDFAST_WITH_CHOLMOD=ON -DHOLDFAST_BUILD_TESTS=ON
# Headers are checked through the sources that include them.
mapfile -t sources < <(printf '%s\n' "${files[@]}" | grep '\.cpp$' | grep -v '^tests/package/widgets_consumer/')
echo "== Names and mistakes in ${#sources[@]} sources"
printf '%s\0' "${sources[@]}" | xargs -0 -n 1 -P "$(build_jobs)" \
  clang-tidy --quiet -p "$database" --extra-arg=-Wno-unknown-warning-option
