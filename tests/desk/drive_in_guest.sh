#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hindsight authors
# SPDX-License-Identifier: BSD-2-Clause
#
# drive_in_guest.sh SOURCE-DIR BUILD-DIR PICTURES, in the guest: arms the daemon, sends it off, pulls the bumper, and
# watches from the bus what it does. Leaves run.lcm, commands.csv and daemon.log in $DESK_DIR. All times are the guest's
# virtual ones (boot -v), hence the same on every machine.
set -u
source=$1
build=$2
pictures=$3
cd "$DESK_DIR" || exit 70
csv=$DESK_DIR/commands.csv
pull=$DESK_GPIO_PULL/sim_gpio0/pull # the left bumper

fail() {
  echo "FAILED: $*"
  echo "--- the daemon's last words:"
  tail -n 30 daemon.log
  echo "--- the last commands on the bus (time, left, right, enable, counter):"
  tail -n 10 "$csv"
  kill -KILL "${daemon:-0}" "${vehicle:-0}" "${camera:-0}" 2>/dev/null
  exit 1
}
ok() { echo "ok: $*"; }
alive() { kill -0 "$daemon" 2>/dev/null || fail "the daemon ended by itself while it should $1"; }
now() { awk '{ print $1 }' /proc/uptime; }
# since T CONDITION: whether a command later than T s fulfils the awk condition (l, r: set-points [m/s]; e: enable).
since() { awk -F, -v t="$1" "NR > 1 && \$1 > t { l = \$2; r = \$3; e = \$4; if ($2) found = 1 } END { exit !found }" "$csv"; }
wait_since() { # T SECONDS CONDITION WHAT
  local end=$((SECONDS + $2))
  until since "$1" "$3"; do
    if [ $SECONDS -ge $end ]; then fail "not within $2 s: $4"; fi
    alive "$4"
    sleep 0.3
  done
  ok "$4"
}

"$build/desk_vehicle" --dbc "$source/config/lagr.dbc" --csv "$csv" >vehicle.log 2>&1 &
vehicle=$!
"$build/feed_camera" --frames "$pictures" --format mjpeg >camera.log 2>&1 &
camera=$!
for _ in $(seq 300); do
  grep -qs feeding camera.log && break
  sleep 0.2
done
grep -q feeding camera.log || fail "the camera does not come up: $(cat camera.log)"

"$build/hindsightd" --config "$source/config/lagr.toml" --config "$source/tests/desk/desk.toml" \
  --record run.lcm >daemon.log 2>&1 &
daemon=$!
wait_since 0 60 '1' "speak on the bus"
since 0 'l != 0 || r != 0' && fail "it moved before it was armed"
ok "stand still until armed"

# Commands are refused until the sensors are there, hence again until the wheels turn.
started=$(now)
for _ in $(seq 60); do
  "$build/hindsight" send arm || fail "hindsight send arm"
  "$build/hindsight" send go-to 30 0 || fail "hindsight send go-to"
  for _ in 1 2 3 4 5; do
    sleep 0.4
    since "$started" 'l > 0.1 && r > 0.1' && break 2
  done
  alive "start"
done
wait_since "$started" 1 'l > 0.1 && r > 0.1' "drive forward to its goal"
sleep 10 # so that there is something to look back on

since "$(awk -v t="$(now)" 'BEGIN { print t - 2 }')" 'l > 0.1 && r > 0.1' || fail "it does not drive any more"
pulled=$(now)
echo pull-up >"$pull"
wait_since "$pulled" 20 'l <= 0 && r <= 0' "command a stop after the bumper was pulled"
stopped=$(awk -F, -v t="$pulled" 'NR > 1 && $1 > t && $2 <= 0 && $3 <= 0 { print $1 - t; exit }' "$csv")
echo "the first command of zero came $stopped s after the pull"
awk -v s="$stopped" 'BEGIN { exit !(s < 0.05) }' || fail "that is more than 0.05 s"
sleep 1
since "$(awk -v t="$pulled" -v s="$stopped" 'BEGIN { print t + s }')" 'l > 0 && r > 0' &&
  fail "a forward command went out while the bumper was pressed"
ok "no forward command while the bumper is pressed"
wait_since "$pulled" 60 'l < -0.05 && r < -0.05 && e' "back up"
echo pull-down >"$pull"
sleep 4

asked=$(now)
kill -TERM "$daemon"
for _ in $(seq 10); do
  kill -0 "$daemon" 2>/dev/null || break
  sleep 0.1
done
kill -0 "$daemon" 2>/dev/null && fail "it has not ended 1 s after SIGTERM"
wait "$daemon"
outcome=$?
[ $outcome -eq 0 ] || fail "its exit status is $outcome"
echo "it ended $(awk -v a="$asked" -v b="$(now)" 'BEGIN { print b - a }') s after SIGTERM"
tail -n 1 "$csv" | awk -F, '{ exit !($2 == 0 && $3 == 0) }' || fail "its last command is not zero"
ok "end by SIGTERM with a last command of zero"
kill "$vehicle" "$camera"
exit 0
