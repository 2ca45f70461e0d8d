#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hindsight authors
# SPDX-License-Identifier: BSD-2-Clause
#
# sim_drive.sh SOURCE-DIR BUILD-DIR, in the guest: the simulator is the world behind the daemon's live drivers (hindsight
# sim --devices). The daemon drives off towards the goal; then it is killed while it drives, and the base must stop the
# wheels by itself. All times are the guest's virtual ones (boot -v).
set -u
source=$1
build=$2
cd "$DESK_DIR" || exit 70
configuration=(--config "$source/config/lagr.toml" --config "$source/tests/desk/sim.toml")

fail() {
  echo "FAILED: $*"
  echo "--- the simulator:"
  tail -n 20 sim.out
  echo "--- the daemon:"
  tail -n 20 daemon.log
  kill -KILL "${daemon:-0}" "${world:-0}" 2>/dev/null
  exit 1
}
ok() { echo "ok: $*"; }
# told FIELD: a number of the simulator's newest line
told() { tail -n 1 sim.out | sed -nE "s/.* ([0-9.]+) $1.*/\1/p"; }
is() { awk -v a="$1" -v b="$3" "BEGIN { exit !(a $2 b) }"; }
wait_for() { # SECONDS FIELD OPERATOR NUMBER WHAT
  local end=$((SECONDS + $1))
  until is "$(told "$2")" "$3" "$4"; do
    if [ $SECONDS -ge $end ]; then fail "not within $1 s: $5"; fi
    sleep 0.5
  done
  ok "$5"
}

"$build/hindsight" sim "$source/sim_replay/courses/desert_road.toml" --devices "${configuration[@]}" >sim.out 2>&1 &
world=$!
wait_for 60 frames '>' 3 "the simulator shows pictures to the camera"
"$build/hindsightd" "${configuration[@]}" --record run.lcm >daemon.log 2>&1 &
daemon=$!
wait_for 60 commands '>' 10 "the daemon's commands reach the simulated base"
is "$(told 'm driven')" '<' 0.05 || fail "it moved before it was armed"

before=$(told 'm to the goal')
for _ in $(seq 30); do # refused until the sensors are there
  "$build/hindsight" send arm && "$build/hindsight" send go-to 60 0
  sleep 1
  if is "$(told 'm driven')" '>' 0.1; then break; fi
done
wait_for 60 'm driven' '>' 5 "it drives off"
is "$(told 'm to the goal')" '<' "$(awk -v b="$before" 'BEGIN { print b - 4 }')" || fail "but not towards the goal"
ok "towards the goal"

kill -KILL $daemon
wait $daemon 2>/dev/null
sleep 2
at=$(told 'm driven')
sleep 3
is "$(told 'm driven')" '<=' "$(awk -v a="$at" 'BEGIN { print a + 0.1 }')" ||
  fail "the base drives on though nobody commands it"
ok "the base stops its wheels when the daemon is killed"
kill -TERM $world
wait $world || fail "the simulator's exit status is $?"
exit 0
