#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hindsight authors
# SPDX-License-Identifier: BSD-2-Clause
#
# gpio.sh SOURCE-DIR BUILD-DIR, in the guest: the chip with bumpers and emergency stop goes and comes back; the emergency
# stop is pressed; a bumper is stuck when the daemon starts.
here=$(cd "$(dirname "$0")" && pwd)
# shellcheck source=tests/desk/faults/common.sh
. "$here/common.sh"
chip=/sys/kernel/config/gpio-sim/desk
pull() { # LINE up|down; the chip has another number when it comes back
  local file
  for file in /sys/devices/platform/gpio-sim.*/gpiochip*/sim_gpio"$1"/pull; do echo "pull-$2" >"$file"; done
}

start_vehicle
start_daemon --record run.lcm
drive

mark t
echo 0 >$chip/live
stops_within 100 "$t" "GPIO chip gone" "GPIO lines"
echo 1 >$chip/live
pause 2.5 # opened anew, with growing pauses
recovers "GPIO chip back"

forget_log
mark t
pull 2 up
stops_within 20 "$t" "emergency stop" "e-stop"
pull 2 down
operator arm
stays_stopped 0.5 "emergency stop let go, armed, not released"
operator release-estop
recovers "emergency stop released"
terminate

pull 1 up
start_daemon
operator arm
pause 0.5
tells "stopped: right bumper stuck" "armed with a bumper pressed since the start"
stays_stopped 0.5 "armed with a bumper pressed since the start"
ok "a bumper pressed since the start: refuses to arm and names it"
pull 1 down
recovers "bumper released"
terminate
