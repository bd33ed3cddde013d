#!/usr/bin/env bash
# Fails where the rooms are not those of docs/rooms.md: with file:line where a room includes one that does not stand
# below it in the table, with the name of a room that is missing there or here, and where the picture is another one.
#   check_rooms.sh ROOT        ROOT is the folder that holds core, widgets, app and docs
set -u
rooms=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../scripts" && pwd)/rooms.sh
cd "$1" || exit 2
page=docs/rooms.md

folders() {
  find core/holdfast widgets/holdfast/widgets app/window/holdfast/window app -mindepth 1 -maxdepth 1 -type d |
    sed -E 's:^core/holdfast/:core/:; s:^(widgets|app/window)/holdfast/::' | grep -v '^app/window$' | sort
}
# A row of the table begins with the room.
table() { sed -nE 's/^\| `([a-z_]+\/[a-z_]+)` \|.*/\1/p' "$page"; }

failures=0
diff <(table | sort) <(folders) | sed -nE "s,^< (.*),$page: no folder for the room \1,p; s,^> (.*),$page: no row for the room \1,p" | grep . && failures=1
"$rooms" . arrows | awk '
  NR == FNR { place[$1] = NR; next }
  place[$1] >= place[$2] { print $3 ": " $1 " includes " $2 ", which does not stand below it"; found = 1 }
  END { exit found }' <(table) - || failures=1
if ! diff <(sed -n '/^```mermaid$/,/^```$/ { /^```/d; p }' "$page") <("$rooms" .) >/dev/null; then
  echo "$page: the picture is not that of scripts/rooms.sh"
  failures=1
fi
exit "$failures"
