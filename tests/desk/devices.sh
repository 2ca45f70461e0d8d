#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hindsight authors
# SPDX-License-Identifier: BSD-2-Clause
#
# devices.sh BUILD-DIR, in the guest: each device of the desk does what the drives on it rely on, seen with the stock
# tools. When a drive fails and this does not, look for the fault in the daemon.
# shellcheck disable=SC2317  # check() calls the functions by name
set -u
build=$(cd "$1" && pwd) || exit 66
failures=0
work=$DESK_DIR/work
rm -rf "$work"
mkdir "$work" && cd "$work" || exit 70

check() { # WHAT CONDITION...
  local what=$1
  shift
  if "$@"; then echo "ok: $what"; else echo "FAILED: $what"; failures=$((failures + 1)); fi
}

# Each starts a watcher in the background, gives it time to begin watching, does something, and waits for its end.
gpio_edge() {
  timeout 20 gpiomon --num-events=1 --rising-edge "${DESK_GPIO_CHIP#/dev/}" 1 >edges &
  sleep 2
  echo pull-up >"$DESK_GPIO_PULL/sim_gpio1/pull"
  wait $!
  grep -q 'RISING EDGE offset: 1' edges
}

can_frame() {
  timeout 20 candump -n 1 vcan0 >frames &
  sleep 2
  cansend vcan0 123#DEADBEEF
  wait $!
  grep -q '123 *\[4\] *DE AD BE EF' frames
}

multicast() {
  timeout 20 lcm-logger -q multicast.lcm &
  local logger=$!
  sleep 2
  for _ in 1 2 3 4 5; do # one short LCM message: magic, sequence number, channel, a payload
    printf 'LC02\0\0\0\0DESK\0hello' >/dev/udp/239.255.76.67/7667
  done
  sleep 1
  kill "$logger"
  wait "$logger"
  grep -qa 'DESKhello' multicast.lcm
}

frames_flow() { # FORMAT FOURCC
  "$build/feed_camera" --frames pictures --format "$1" --count 3 --rate 20 >feed &
  local feed=$!
  for _ in $(seq 100); do grep -q feeding feed && break; sleep 0.1; done
  v4l2-ctl --device /dev/video10 --get-fmt-video | grep -q "'$2'" &&
    timeout 60 v4l2-ctl --device /dev/video10 --stream-mmap --stream-count=10 --stream-to="$1" 2>/dev/null &&
    [ "$(stat -c %s "$1")" -gt 100000 ]
  local outcome=$?
  kill "$feed"
  wait "$feed"
  return "$outcome"
}

"$build/draw_road" pictures 3
check "gpiomon sees an edge of a pulled line" gpio_edge
check "gpioinfo names the lines" test "$(gpioinfo | grep -c -E 'bumper_left|bumper_right|estop')" -eq 3
check "candump sees a frame on vcan0" can_frame
check "a multicast message reaches lcm-logger" multicast
check "MJPEG frames written to /dev/video10 are captured" frames_flow mjpeg MJPG
check "YUYV frames written to /dev/video10 are captured" frames_flow yuyv YUYV
exit $((failures > 0))
