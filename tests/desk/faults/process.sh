#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hindsight authors
# SPDX-License-Identifier: BSD-2-Clause
#
# process.sh SOURCE-DIR BUILD-DIR, in the guest: each thread of the daemon is frozen in turn, the loop is held up, the
# clock is set, memory is refused, the process is told to end and killed.
here=$(cd "$(dirname "$0")" && pwd)
# shellcheck source=tests/desk/faults/common.sh
. "$here/common.sh"
export NOTIFY_SOCKET=/run/notify
"$here/listen_as_systemd.py" $NOTIFY_SOCKET >notify.log &
until_true 5 "nobody listens at $NOTIFY_SOCKET" test -S $NOTIFY_SOCKET

freeze() { "$here/freeze_thread.py" "$daemon" "$@"; }
# pings FROM TO: how often the watchdog was fed between the two times
pings() { awk -v a="$1" -v b="$2" '{ t = $1 * 1000 } t > a && t <= b && /WATCHDOG=1/ { n++ } END { print n + 0 }' notify.log; }
# hangs THREAD MILLISECONDS: no motion is commanded later than that after it froze; the process ends, for systemd to
# restart it
hangs() {
  local t end
  start_daemon
  drive
  mark t
  freeze "$1" 6 &
  ends 70 4 "thread $1 hangs" # a second of silence, one more for the flight recorder, python's start
  mark end
  [ "$(commands $((t + $2)) "$end" 'l != 0 || r != 0')" -eq 0 ] ||
    fail "thread $1 hangs: it still commanded motion after $2 ms"
  tells "thread $1 hangs" "thread $1 hangs"
  [ "$(pings $((t + 1300)) "$end")" -eq 0 ] || fail "thread $1 hangs: the watchdog was still fed"
  ok "thread $1 hangs: no motion after $2 ms, the watchdog is fed no more"
}

# The flight recorder's files.
count_faults() { find /run/faults -name "fault_*_$1.lcm" 2>/dev/null | wc -l; }

start_vehicle
hangs loop 350
[ "$(count_faults thread_lost)" -eq 1 ] || fail "thread loop hangs: the flight recorder left nothing: $(ls /run/faults)"
ok "thread loop hangs: the flight recorder wrote the seconds before"
hangs reflex 100
hangs camera 500
hangs can 350
hangs gpio 350
hangs command 1500
hangs publisher 1500
hangs flight 1500

start_daemon --record run.lcm
drive
mark t
freeze main 1.5
mark end
[ "$(pings $((t + 200)) $((end - 100)))" -eq 0 ] || fail "the main thread hangs: the watchdog is still fed"
pause 0.5
[ "$(pings "$end" $((end + 500)))" -gt 2 ] || fail "the main thread goes on: the watchdog is not fed again"
ok "the main thread hangs: the watchdog is fed no more"

date -s "+1 hour" >/dev/null
pause 0.5
moves || fail "clock set forward by an hour: it does not drive on"
date -s "-3 hours" >/dev/null
pause 0.5
moves || fail "clock set back by three hours: it does not drive on"
ok "clock set forward and back: drives on"
operator stop
pause 0.3
tells "stopped: operator stop" "clock set back"
drive
ok "clock set back: obeys its operator"

prlimit --pid "$daemon" --as=1000000
pause 1
moves || fail "no more memory to be had: it does not drive on"
prlimit --pid "$daemon" --as=unlimited
ok "no more memory to be had: drives on"

forget_log
mark t
freeze loop 0.2 14 0.01 # ten ticks in a row are late, whatever the phase
stops_within 2500 "$t" "the loop is late at each tick" overruns
recovers "the loop keeps its time again"

mark t
kill -TERM "$daemon"
ends 0 1 "SIGTERM"
tail -n 1 "$csv" | awk -F, '{ exit !($2 == 0 && $3 == 0) }' || fail "SIGTERM: its last command is not zero"
grep -q STOPPING=1 notify.log || fail "SIGTERM: systemd is not told"
ok "SIGTERM: zero, then the end"

start_daemon
drive
kill -KILL "$daemon"
ends 137 1 "SIGKILL"
