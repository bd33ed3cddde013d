#!/usr/bin/env bash
# What with_display.sh promises: the command's exit code, a display that answers, servers apart, none left behind.
#   with_display_test.sh
set -u
with_display=$(dirname "${BASH_SOURCE[0]}")/with_display.sh
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export TMPDIR=$folder
failures=0

# expect WHAT WANTED GOT
expect() {
  [ "$2" = "$3" ] && return
  echo "$1: wanted $2, got $3"
  failures=$((failures + 1))
}

server_of_display='tr "\0" " " </proc/net/unix | grep -c "@/tmp/.X11-unix/X${DISPLAY#:}\$"'
# A dead process that nobody waited for (an orphan in a container without init) counts as ended.
is_running() { grep -s '^State:' "/proc/$1/status" | grep -qv 'Z (zombie)'; }

for code in 0 1 5 77; do
  "$with_display" bash -c "exit $code"
  expect "exit code" "$code" $?
done
"$with_display" bash -c 'kill -TERM $$' 2>/dev/null
expect "exit code of a command that a signal ended" 143 $?
"$with_display" "$folder/absent" 2>/dev/null
expect "exit code of a command that does not exist" 127 $?

expect "servers that listen on the display" 1 "$("$with_display" bash -c "$server_of_display")"

# Two at once: each waits until both have their display, through a pipe each way.
mkfifo "$folder/a" "$folder/b"
"$with_display" bash -c 'echo $DISPLAY >'"$folder/a"'; read -r other <'"$folder/b"'; [ "$other" != "$DISPLAY" ]' &
first=$!
"$with_display" bash -c 'read -r other <'"$folder/a"'; echo $DISPLAY >'"$folder/b"'; [ "$other" != "$DISPLAY" ]'
expect "two at once have displays apart" 0 $?
wait "$first"
expect "two at once have displays apart, seen from the other" 0 $?

# $PPID of the command is the script; the server is the script's first child.
first_sibling='read -r pid _ </proc/$PPID/task/$PPID/children; echo $pid'
"$with_display" bash -c "$first_sibling; tr '\\0' ' ' </proc/\$pid/cmdline" >"$folder/ended"
expect "name of the server" Xvfb "$(sed -n '2s/ .*//p' "$folder/ended")"
is_running "$(head -n 1 "$folder/ended")"
expect "whether the server outlives its command (1: no)" 1 $?

{ "$with_display" bash -c "$first_sibling >$folder/killed; kill -KILL \$PPID"; } 2>/dev/null
# The kernel's signal comes at its own time: a server that stays is a time-out of the test.
while is_running "$(cat "$folder/killed")"; do :; done

# A server that does not listen does not keep its test from ending.
mkdir "$folder/bin"
cat >"$folder/bin/Xvfb" <<'END'
#!/usr/bin/env bash
trap '' TERM
echo 999
exec sleep 600
END
chmod +x "$folder/bin/Xvfb"
PATH=$folder/bin:$PATH timeout --signal=KILL 60 "$with_display" true 2>/dev/null
expect "exit code where the server does not listen" 0 $?

exit "$failures"
