#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hindsight authors
# SPDX-License-Identifier: BSD-2-Clause
#
# can.sh SOURCE-DIR BUILD-DIR, in the guest: the CAN bus goes off, down, away; it babbles; the base falls silent.
here=$(cd "$(dirname "$0")" && pwd)
# shellcheck source=tests/desk/faults/common.sh
. "$here/common.sh"
# no_motion_since T WHAT: for faults that keep even zero from the bus
no_motion_since() {
  local end
  mark end
  [ "$(commands "$1" "$end" 'l != 0 || r != 0')" -eq 0 ] || fail "$2: it commanded motion"
  tells "stopped: CAN bus" "$2"
  ok "$2: no command of motion since"
}

start_vehicle
start_daemon --record run.lcm
drive

mark t
cansend vcan0 20000040#0000000000000000 # an error frame: bus-off
stops_within 150 "$t" "bus-off" "CAN bus"
operator arm
stays_stopped 0.5 "armed while the bus is off"
cansend vcan0 20000100#0000000000000000 # an error frame: restarted
recovers "bus restarted"

forget_log
ip link set vcan0 down
mark t
pause 1
tells "stopped: CAN bus" "link down"
ip link set vcan0 up
pause 1 # the receiver opens its socket anew, with growing pauses
no_motion_since "$t" "link down and up"
recovers "link up again"

forget_log
ip link del vcan0
mark t
pause 1
kill "$vehicle" 2>/dev/null # if it has not ended by itself
wait "$vehicle" 2>/dev/null
csv=$DESK_DIR/commands_2.csv
ip link add vcan0 type vcan && ip link set vcan0 txqueuelen 1000 up
start_vehicle
pause 2.5
no_motion_since "$t" "interface deleted and made again"
recovers "interface back"

# WHEEL_ENCODERS with bytes that no base would send, more often than a bus of 500 kbit/s can carry it.
cangen vcan0 -g 0.2 -I 100 -L 8 -D r &
babbler=$!
pause 2
moves || fail "a babbling node: it does not drive on"
kill $babbler
wait $babbler 2>/dev/null
ok "a babbling node: drives on"

forget_log
mark t
kill -STOP "$vehicle"
pause 1
kill -CONT "$vehicle" # reads now what was sent to it meanwhile, hence with a time of now
stops_within 1050 "$t" "the base is silent" "wheel encoders"
recovers "the base speaks again"
terminate
