#!/usr/bin/env bash
# The rooms of the sources, from their includes. docs/rooms.md shows the picture; tests compare the two.
#   scripts/rooms.sh [ROOT]            the picture: from each room to those that it includes, without arrows that follow
#                                      from others
#   scripts/rooms.sh ROOT arrows       every include across rooms: FROM TO FILE:LINE
set -euo pipefail
cd "${1:-$(dirname "${BASH_SOURCE[0]}")/..}"

# A room is a folder in core/holdfast, widgets/holdfast/widgets, app/window/holdfast/window, or app. The front door,
# holdfast.h, is none.
arrows() {
  grep -rnoE --include='*.h' --include='*.cpp' --exclude=holdfast.h '^[[:space:]]*#[[:space:]]*include[[:space:]]*[<"]holdfast/[^>"]+/[^>"]+' core widgets app |
    awk -F: '
      function first_two(path, parts) { split(path, parts, "/"); return parts[1] "/" parts[2] }
      function room_of_file(path) {
        if (!sub(/^core\/holdfast\//, "core/", path)) sub(/^(widgets|app\/window)\/holdfast\//, "", path)
        return first_two(path)
      }
      function room_of_include(path) {
        sub(/.*holdfast\//, "", path)
        return first_two(path ~ /^(widgets|window)\// ? path : "core/" path)
      }
      {
        from = room_of_file($1)
        to = room_of_include($3)
        if (from != to) print from, to, $1 ":" $2
      }' | sort
}

picture() {
  arrows | awk '
    function id(room) { gsub("/", "_", room); return room }
    { includes[$1, $2] = reaches[$1, $2] = 1; rooms[$1]; rooms[$2] }
    END {
      split("app window widgets core", order)
      for (k in order) floor[order[k]] = k == 1 ? 2 : k
      for (via in rooms) for (from in rooms) for (to in rooms)
        if ((from, via) in reaches && (via, to) in reaches) reaches[from, to] = 1
      for (room in rooms) {
        split(room, parts, "/")
        print floor[parts[1]], parts[1] == "window" ? "app" : parts[1], id(room) "[" parts[2] "]"
      }
      for (from in rooms) for (to in rooms) {
        if (!((from, to) in includes)) continue
        follows = 0
        for (via in rooms) if ((from, via) in includes && (via, to) in reaches) follows = 1
        if (!follows) print "5 end", id(from) " --> " id(to)
      }
    }' | sort | awk '
    BEGIN { print "flowchart TD" }
    $2 != floor { if (floor) print "  end"; floor = $2; if (floor != "end") print "  subgraph " floor }
    { sub(/^[^ ]+ [^ ]+ /, ""); print (floor == "end" ? "  " : "    ") $0 }'
}

if [ "${2:-}" = arrows ]; then arrows; else picture; fi
