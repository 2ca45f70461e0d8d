#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hindsight authors
# SPDX-License-Identifier: BSD-2-Clause
#
# disk_network.sh SOURCE-DIR BUILD-DIR, in the guest: the disk that the run is recorded on is full; LCM's network is
# absent at the start, comes, and goes.
here=$(cd "$(dirname "$0")" && pwd)
# shellcheck source=tests/desk/faults/common.sh
. "$here/common.sh"
# sent NAME: how many datagrams this machine has sent so far, into the variable NAME
sent() {
  local line
  while read -r line; do
    [[ $line =~ ^Udp:\ ([0-9]+)\ [0-9]+\ [0-9]+\ ([0-9]+) ]] && printf -v "$1" %d "${BASH_REMATCH[2]}"
  done </proc/net/snmp
}
telemetry_flows() { # within half a second: several messages a tick
  local before after
  sent before
  pause 0.5
  sent after
  [ $((after - before)) -gt 15 ]
}
route() { ip route "$1" 224.0.0.0/4 dev lo; }

mkdir /run/small && mount -t tmpfs -o size=6m tmpfs /run/small
route del
start_vehicle
start_daemon --record /run/small/run.lcm
drive
tells "no telemetry" "no network at the start"
telemetry_flows && fail "no network at the start: telemetry flows"
ok "no network at the start: drives, and says so"
until_true 20 "disk full: the log does not tell" says "recording ended: No space left"
pause 0.5
moves || fail "disk full: it does not drive on"
ok "disk full: drives on, $(grep -o 'recording ended.*' "$daemon_log")"
cp /run/small/run.lcm full_disk.lcm

route add
until_true 8 "the network is there: no telemetry" telemetry_flows
ok "the network is there: telemetry flows"
route del
pause 0.5
telemetry_flows && fail "no route any more: telemetry flows"
moves || fail "no route any more: it does not drive on"
route add
telemetry_flows || fail "the route is back: no telemetry"
moves || fail "the route is back: it does not drive on"
ok "the route goes and comes back: drives on, telemetry resumes"
terminate
