#!/usr/bin/env bash
# Runs a command under a Wayland compositor of its own, without a screen, and ends with the command's exit code.
#   with_wayland.sh COMMAND [ARGUMENT...]
# Ends with 77, CTest's word for a test that is skipped, where there is no compositor (packages weston and qtwayland5).
# DISPLAY is left as it is: with_display.sh around this one gives an X server as well.
set -u

if ! command -v weston >/dev/null; then
  echo "skipped: weston is not installed (apt-get install weston qtwayland5)" >&2
  exit 77
fi
folder=$(mktemp -d)
# As sessions of desktops set it: Qt draws on Wayland then, also where there is an X server.
export XDG_RUNTIME_DIR=$folder LIBGL_ALWAYS_SOFTWARE=1 XDG_SESSION_TYPE=wayland
unset QT_QPA_PLATFORM
# The compositor starts a command of its own once it takes clients.
mkfifo "$folder/ready"
printf '#!/bin/sh\necho ready >%q\n' "$folder/ready" >"$folder/tell"
chmod +x "$folder/tell"
printf '[core]\nidle-time=0\n[autolaunch]\npath=%s\n' "$folder/tell" >"$folder/weston.ini"
setpriv --pdeathsig TERM weston --backend=headless-backend.so --width=1280 --height=1024 --socket=holdfast \
  --config="$folder/weston.ini" >"$folder/log" 2>&1 &
compositor=$!

end_compositor() {
  kill "$compositor" 2>/dev/null
  wait "$compositor" 2>/dev/null
  rm -rf "$folder"
}
trap end_compositor EXIT

# Open for both, so that this does not wait for a compositor that has ended.
exec {ready}<>"$folder/ready"
if ! read -r -t 60 -u "$ready" _; then
  echo "error: the Wayland compositor of the tests (weston) did not start:" >&2
  cat "$folder/log" >&2
  exit 1
fi
WAYLAND_DISPLAY=holdfast "$@" {ready}<&-
