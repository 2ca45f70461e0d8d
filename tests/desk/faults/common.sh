# shellcheck shell=bash
# SPDX-FileCopyrightText: 2026 The Hindsight authors
# SPDX-License-Identifier: BSD-2-Clause
#
# Sourced by the fault scripts, in the guest: a live daemon that drives the desk's vehicle, and what one may expect of it
# when something fails. Commands are seen from the bus (desk_vehicle's commands.csv), reasons in the daemon's log. Times
# are the guest's own, in milliseconds; with boot -v they are virtual, hence the same on every machine. A program takes
# long to start in the guest, so that the shell does by itself what it can.
set -u
source=$1
build=$2
daemon_log=$DESK_DIR/daemon.log
csv=$DESK_DIR/commands.csv
daemon=
vehicle=
cd "$DESK_DIR" || exit 70
rm -f ./*.log ./*.csv
mkfifo /run/never
exec 9<>/run/never

fail() {
  echo "FAILED: $*"
  echo "--- the daemon's last words:"
  tail -n 20 "$daemon_log"
  echo "--- the last commands on the bus (time, left, right, enable, counter):"
  tail -n 5 "$csv"
  kill -KILL ${daemon:+"$daemon"} ${vehicle:+"$vehicle"} 2>/dev/null
  exit 1
}
ok() { echo "ok: $*"; }
# mark NAME: the time [ms] into the variable NAME
mark() {
  local seconds
  read -r seconds _ </proc/uptime
  printf -v "$1" %d "$((10#${seconds/./} * 10))"
}
pause() { read -rt "$1" _ <&9; } # SECONDS
alive() { kill -0 "$daemon" 2>/dev/null; }
ended() { ! alive; }
# commands FROM TO CONDITION: how many commands between the two times fulfil the awk condition (l, r: set-points [m/s],
# e: enable)
commands() {
  awk -F, -v a="$1" -v b="$2" "{ t = \$1 * 1000; l = \$2; r = \$3; e = \$4 } NR > 1 && t > a && t <= b && ($3) { n++ } END { print n + 0 }" "$csv"
}
until_true() { # SECONDS WHAT COMMAND...: until COMMAND succeeds
  local end now what=$2
  mark end
  end=$((end + 1000 * $1))
  shift 2
  until "$@"; do
    mark now
    if [ "$now" -ge "$end" ]; then fail "$what"; fi
    pause 0.1
  done
}
says() { grep -q "$1" "$daemon_log"; }
# tells TEXT WHAT: the daemon's log, since forget_log, holds TEXT
tells() { says "$1" || fail "$2: the log does not say \"$1\""; }
forget_log() { : >"$daemon_log"; }

start_vehicle() {
  "$build/desk_vehicle" --dbc "$source/config/lagr.dbc" --csv "$csv" >>vehicle.log 2>&1 &
  vehicle=$!
}
# start_daemon [ARGUMENT...]: in the background, its log begun anew, until its sensors give data
start_daemon() {
  forget_log
  "$build/hindsightd" --config "$source/config/lagr.toml" --config "$source/tests/desk/faults/faults.toml" \
    "$@" >>"$daemon_log" 2>&1 &
  daemon=$!
  until_true 20 "it does not come up" says "ready:"
}
moves() {
  local to
  mark to
  [ "$(commands $((to - 300)) "$to" 'l > 0.1 && r > 0.1')" -gt 10 ]
}
operator() { "$build/desk_operator" "$1" || fail "desk_operator $1"; }
# drive: arms it and sends it off, also after a stop, and waits until it drives
drive() {
  operator drive
  pause 0.8
  moves && return
  operator drive # a sensor was not back yet
  until_true 5 "it does not drive after arm and go-to" moves
}

# stops_within MILLISECONDS SINCE WHAT REASON: no command but zero later than that after SINCE, and none for the next half
# a second though the daemon goes on speaking; the log tells REASON.
stops_within() {
  local limit=$1 since=$2 what=$3 reason=$4 end
  until_true 5 "$what: half a second has not passed" later_than $((since + limit + 500))
  alive || fail "$what: the daemon ended"
  mark end
  awk -F, -v since="$since" -v limit="$limit" -v end="$end" '
    NR > 1 && $1 * 1000 > since && $1 * 1000 <= end {
      after = $1 * 1000 - since
      if ($2 != 0 || $3 != 0 || $4) last = after
      if (after > limit) spoken++
    }
    END { printf "%.0f", last; exit !(last <= limit && spoken > 10) }' "$csv" >last_motion ||
    fail "$what: it still commands motion after $(cat last_motion) ms, or speaks no more"
  tells "stopped: $reason" "$what"
  ok "$what: last command of motion after $(<last_motion) ms (at most $limit), \"$reason\""
}
later_than() {
  local t
  mark t
  [ "$t" -ge "$1" ]
}
# stays_stopped SECONDS WHAT: latched, though the cause is gone
stays_stopped() {
  local begin end
  mark begin
  pause "$1"
  mark end
  [ "$(commands "$begin" "$end" 'l != 0 || r != 0')" -eq 0 ] || fail "$2: it drives on without being armed"
}
# recovers WHAT: still stands after the cause is gone, and drives when it is armed
recovers() {
  stays_stopped 0.7 "$1"
  drive
  ok "$1: stands until armed, then drives on"
}
# ends STATUS SECONDS WHAT: the daemon ends by itself within SECONDS with STATUS
ends() {
  local status
  until_true "$2" "$3: it does not end within $2 s" ended
  wait "$daemon" 2>/dev/null
  status=$?
  [ $status -eq "$1" ] || fail "$3: its exit status is $status, not $1"
  ok "$3: ends with status $1"
}
terminate() {
  kill -TERM "$daemon"
  ends 0 2 "SIGTERM"
}
