#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hindsight authors
# SPDX-License-Identifier: BSD-2-Clause
#
# live_drive.sh SOURCE-DIR BUILD-DIR
#
# hindsightd with its real drivers on the vehicle on a desk: a camera that shows a drive, a CAN bus with a vehicle's base
# at its other end, a bumper that is pulled. drive_in_guest.sh is the drive; what it recorded is judged here, outside.
# The camera shows $HINDSIGHT_DATA/road_kitti0019, or pictures drawn for the purpose where there is no such folder.
set -euo pipefail
source=$1
build=$2
here=$(cd "$(dirname "$0")" && pwd)
work=$build/desk/live_drive
rm -rf "$work"
mkdir -p "$work"

pictures=${HINDSIGHT_DATA:-}/road_kitti0019
if [ ! -d "$pictures" ]; then
  pictures=$work/pictures
  "$build/draw_road" "$pictures" 150
fi
echo "camera: $pictures"

"$here/boot" -v -o "$work" -t 900 "$here/drive_in_guest.sh" "$source" "$build" "$pictures"
"$build/check_log" "$work/run.lcm"
"$build/hindsight" verify "$work/run.lcm"
echo "ok: the recorded log replays byte for byte"
