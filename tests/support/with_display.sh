#!/usr/bin/env bash
# Runs a command with an X server of its own and ends with the command's exit code.
#   with_display.sh COMMAND [ARGUMENT...]
# HOLDFAST_SCREEN is the size of its screen, 1280x1024 where it is not set.
# The server picks a free number itself and tells it once it listens, so two of these never meet on one display; it
# is ended by its own pid, by force where it does not listen, and by the kernel should this script be killed.
set -u

log=$(mktemp)
exec {number}< <(exec setpriv --pdeathsig TERM Xvfb -displayfd 1 -screen 0 "${HOLDFAST_SCREEN:-1280x1024}x24" -noreset -nolisten tcp 2>"$log")
server=$!

end_server() {
  rm -f "$log"
  kill "$server" 2>/dev/null
  timeout 5 tail --pid="$server" --sleep-interval=0.01 -f /dev/null || kill -KILL "$server"
  wait "$server" 2>/dev/null
}
trap end_server EXIT

if ! read -r -t 60 -u "$number" display; then
  echo "error: the X server of the tests (Xvfb, package xvfb) did not start:" >&2
  cat "$log" >&2
  exit 1
fi

# Mesa's software renderer draws the same picture on every machine.
export DISPLAY=:$display QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1
unset WAYLAND_DISPLAY XAUTHORITY
"$@" {number}<&-
