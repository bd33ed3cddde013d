#!/usr/bin/env bash
# Fails with file:line where a source includes anything before the header of its own name: only as the first include
# is a header compiled with nothing before it.
#   check_own_headers.sh ROOT        ROOT is the folder that holds core, widgets and app
set -u
cd "$1" || exit 2

failures=0
while read -r source; do
  header=${source%.cpp}.h
  [ -e "$header" ] || continue
  first=$(grep -nE -m1 '^[[:space:]]*#[[:space:]]*include' "$source")
  case "$first" in
    *"\"holdfast/${header##*/holdfast/}\"") ;;
    *)
      echo "$source:${first:-1:}"
      failures=1
      ;;
  esac
done < <(find core widgets app/window -name '*.cpp')
exit "$failures"
