#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hindsight authors
# SPDX-License-Identifier: BSD-2-Clause
#
# camera.sh SOURCE-DIR BUILD-DIR, in the guest: the camera is unplugged, hangs, gives broken frames, breaks down, comes
# back; its program is killed; it gives another size than asked for.
here=$(cd "$(dirname "$0")" && pwd)
# shellcheck source=tests/desk/faults/common.sh
. "$here/common.sh"
control() { v4l2-ctl -d /dev/video0 --set-ctrl "$1" || fail "vivid has no control $1"; }

start_vehicle
start_daemon --record run.lcm
drive

mark t
control disconnect=1
stops_within 300 "$t" "camera unplugged" camera
recovers "camera plugged in again"
until_true 5 "camera unplugged: no flight recorder's log" says "flight recorder: .*camera.lcm"
mv /run/faults/fault_*_camera.lcm flight.lcm
ok "camera unplugged: $(grep -o 'flight recorder: [0-9]* ticks' "$daemon_log")"

forget_log
mark t
control percentage_of_dropped_buffers=100
stops_within 400 "$t" "camera stalls" camera
pause 3 # longer than camera.restart_s: it is opened anew meanwhile
control percentage_of_dropped_buffers=0
recovers "camera gives frames again"

control inject_v4l2_buf_flag_error=1
pause 0.5
moves || fail "one broken frame: it stops"
ok "one broken frame: dropped, drives on"

forget_log
mark t
for _ in $(seq 18); do # at twice the frames' rate
  control inject_v4l2_buf_flag_error=1
  pause 0.05
done
stops_within 400 "$t" "frames marked as broken" camera
recovers "whole frames again"

forget_log
mark t
control inject_fatal_streaming_error=1
stops_within 400 "$t" "streaming breaks down" camera
recovers "camera opened anew"
terminate

# A camera that is a program: it gives another size than asked for, then dies and comes back.
"$build/draw_road" pictures 3
feed() { # WIDTH HEIGHT
  "$build/feed_camera" --frames pictures --format yuyv --width "$1" --height "$2" >feed.log 2>&1 &
  feeder=$!
  until_true 5 "the camera does not come up" grep -qs feeding feed.log
}
feed 640 360
sed "s|/dev/video0|/dev/video10|; s|camera.yaml|$here/&|" "$here/faults.toml" >loopback.toml
"$build/hindsightd" --config "$source/config/lagr.toml" --config loopback.toml >wrong_size.log 2>&1
status=$?
[ "$status" -eq 69 ] || fail "the camera gives another size: exit status $status, not 69: $(cat wrong_size.log)"
grep -q "640 x 360" wrong_size.log || fail "the camera gives another size: not said: $(cat wrong_size.log)"
ok "the camera gives another size: refused at start: $(grep -o 'asked for.*' wrong_size.log)"
kill "$feeder"
feed 320 180
start_daemon --config loopback.toml
drive
mark t
kill "$feeder"
stops_within 400 "$t" "the camera's program killed" camera
feed 320 180
recovers "the camera's program started again"
terminate
