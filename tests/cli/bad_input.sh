#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hindsight authors
# SPDX-License-Identifier: BSD-2-Clause
#
# bad_input.sh SOURCE-DIR BUILD-DIR
#
# What a user may get wrong, as he would: each case must end with the documented exit code and a message that names file
# and place.
set -uo pipefail
source=$1
build=$2
work=$build/cli
rm -rf "$work"
mkdir -p "$work"
cd "$work"
failed=0

# expect CODE PATTERN COMMAND...
expect() {
  local code=$1 pattern=$2
  shift 2
  local output status
  output=$("$@" 2>&1 </dev/null)
  status=$?
  if [ "$status" -ne "$code" ] || ! grep -qE -- "$pattern" <<<"$output"; then
    printf 'FAILED: %s\n  exit code %d (expected %d), message (expected /%s/):\n%s\n' "$*" "$status" "$code" "$pattern" "$output"
    failed=1
  else
    printf 'ok: %-3d %s\n' "$code" "$(tail -n 1 <<<"$output" | cut -c1-150)"
  fi
}

daemon=$build/hindsightd
tool=$build/hindsight
cp "$source"/config/lagr.toml "$source"/config/lagr.dbc "$source"/config/camera.yaml .
overlay() { printf '%b' "$2" >"$1"; }

# The command line
expect 64 'ERROR|not expected|The following argument' "$daemon" --no-such-option
expect 64 '--config' "$daemon"
expect 64 'pace' "$daemon" --config lagr.toml --pace 1
expect 0 'configuration ok' "$daemon" --config lagr.toml --check-config
expect 0 'hindsight 0' "$daemon" --version

# Configuration
expect 66 'absent.toml' "$daemon" --config absent.toml --check-config
overlay unknown.toml '[robot]\nlop_rate_hz = 5.0\n'
expect 78 'unknown.toml:2:1.*lop_rate_hz.*loop_rate_hz' "$daemon" --config lagr.toml --config unknown.toml --check-config
overlay type.toml '[robot]\n\nloop_rate_hz = "fast"\n'
expect 78 'type.toml:3:.*loop_rate_hz' "$daemon" --config lagr.toml --config type.toml --check-config
overlay range.toml '[robot]\nloop_rate_hz = 1000.0\n'
expect 78 'range.toml:2:.*1 to 100' "$daemon" --config lagr.toml --config range.toml --check-config
overlay section.toml '[robto]\nmode = "drive"\n'
expect 78 'section.toml:1:.*robto' "$daemon" --config lagr.toml --config section.toml --check-config
overlay broken.toml '[robot\n'
expect 78 'broken.toml:1:' "$daemon" --config lagr.toml --config broken.toml --check-config
"$daemon" --config lagr.toml --print-config >printed.toml
expect 0 'configuration ok' "$daemon" --config printed.toml --check-config

# Calibration and CAN protocol
overlay size.toml '[camera]\nwidth_px = 640\n'
expect 65 '640.*720|720.*640' "$daemon" --config lagr.toml --config size.toml --check-config
overlay nocam.toml '[robot]\ncalibration = "absent.yaml"\n'
expect 66 'absent.yaml' "$daemon" --config lagr.toml --config nocam.toml --check-config
grep -v camera_matrix camera.yaml >nomatrix.yaml
overlay badcam.toml '[robot]\ncalibration = "nomatrix.yaml"\n'
expect 65 'nomatrix.yaml' "$daemon" --config lagr.toml --config badcam.toml --check-config
sed 's/LEFT_CURRENT/LEFT_AMPERE/' lagr.dbc >renamed.dbc
overlay dbc.toml '[can.roles]\ndbc = "renamed.dbc"\n'
expect 78 'renamed.dbc.*LEFT_CURRENT|LEFT_CURRENT.*renamed.dbc' "$daemon" --config lagr.toml --config dbc.toml --check-config

# Devices
overlay device.toml '[camera]\ndevice = "/dev/hindsight-no-such-camera"\n[can]\ninterface = "hs-no-can0"\n[robot]\nmodel_file = ""\nstate_file = ""\n'
expect 69 'hs-no-can0|hindsight-no-such-camera' "$daemon" --config lagr.toml --config device.toml

# Importing
"$build/draw_road" pictures 12 >/dev/null
size=$(identify -format '%wx%h' "$(ls pictures/* | head -n 1)")
sed "s/^image_width:.*/image_width: ${size%x*}/; s/^image_height:.*/image_height: ${size#*x}/" camera.yaml >pictures.yaml
mkdir -p empty mixed
cp pictures/* mixed/
convert -size 64x48 xc:red "mixed/$(ls pictures | tail -n 1)"
expect 66 'no-such-folder' "$tool" import --frames no-such-folder --rate 10 --camera pictures.yaml -o x.lcm
expect 66 'empty' "$tool" import --frames empty --rate 10 --camera pictures.yaml -o x.lcm
expect 65 "mixed/.*64" "$tool" import --frames mixed --rate 10 --camera pictures.yaml -o x.lcm
overlay track.csv 'time_s,left_mps,right_mps\n0,1,1\n0.1,fast,1\n'
expect 65 'track.csv:3:.*left_mps' "$tool" import --frames pictures --rate 10 --camera pictures.yaml --track track.csv -o x.lcm
overlay column.csv 'time_s,left_mph\n0,1\n'
expect 65 'column.csv:1:.*left_mph' "$tool" import --frames pictures --rate 10 --camera pictures.yaml --track column.csv -o x.lcm
expect 64 'rate' "$tool" import --frames pictures --rate 0 --camera pictures.yaml -o x.lcm
overlay good.csv 'time_s,left_mps,right_mps,bumper_left,bumper_right,estop\n0,1,1,0,0,0\n0.5,1,1,1,0,0\n1.0,1,1,0,0,0\n'
expect 0 '12 frames' "$tool" import --frames pictures --rate 10 --camera pictures.yaml --track good.csv -o good.lcm

# Logs
expect 66 'absent.lcm' "$daemon" --replay absent.lcm
expect 65 'camera.yaml' "$daemon" --replay camera.yaml
expect 0 '' "$daemon" --replay good.lcm --record run.lcm
expect 0 'identical' "$tool" verify run.lcm
expect 65 'holds no ticks' "$tool" verify good.lcm
head -c $(($(stat -c %s run.lcm) - 1000)) run.lcm >cut.lcm
expect 65 'cut.lcm.*byte [0-9]+' "$daemon" --replay cut.lcm
expect 0 'damage at byte [0-9]+' "$daemon" --replay cut.lcm --recover
expect 74 'no-such-folder' "$daemon" --replay good.lcm --record no-such-folder/out.lcm
expect 74 'full' "$daemon" --replay good.lcm --record /dev/full

# A log that differs: one published number changed
python3 - run.lcm changed.lcm <<'PY'
import struct, sys
data = bytearray(open(sys.argv[1], 'rb').read())
offset = ticks = 0
while offset < len(data):
    _, _, _, channel_length, size = struct.unpack('>IqqII', data[offset:offset + 28])
    channel = data[offset + 28:offset + 28 + channel_length]
    start = offset + 28 + channel_length
    if channel == b'HINDSIGHT_STATE':
        ticks += 1
        if ticks == 5:
            data[start + 8 + 8 + 8 + 4 + 8 + 3] ^= 1  # in position_m[1]
            break
    offset = start + size
open(sys.argv[2], 'wb').write(data)
PY
expect 1 'tick 4, channel HINDSIGHT_STATE, field position_m\[1\]' "$tool" verify changed.lcm

expect 66 'absent.lcm' "$tool" report absent.lcm -o report
expect 66 'absent' "$tool" eval traceback --frames absent
expect 66 'absent' "$tool" eval planner --maps absent
expect 66 'absent' "$tool" eval road --frames absent --truth absent --rate 10
expect 64 'rate' "$tool" eval road --frames . --truth . --rate 0
expect 66 'absent.toml' "$tool" render absent.toml -o out
overlay outside.toml '[road]\nenabled = true\ndefinition_centre = 0.0\n'
expect 66 'absent.csv' "$tool" eval slip --csv absent.csv --rate 10

# Simulation
courses=$source/sim_replay/courses
printf '[can]\ninterface = "nocan0"\n[robot]\ncalibration = "%s"\n[can.roles]\ndbc = "%s"\n' \
  "$source/config/camera.yaml" "$source/config/lagr.dbc" >nocan.toml
expect 64 'course' "$tool" sim
expect 66 'absent.toml' "$tool" sim absent.toml
overlay course.toml '[course]\nname = "x"\nlenght_m = 70.0\n'
expect 78 'course.toml:3:1.*lenght_m.*length_m' "$tool" sim course.toml
overlay inside.toml '[course]\nname = "x"\n[trees]\nat_m = [0.2, 0.1]\n'
expect 78 'inside.toml: the start .* tree' "$tool" sim inside.toml
expect 69 'no EGL' env __EGL_VENDOR_LIBRARY_FILENAMES=/absent "$tool" sim "$courses/forest.toml" --seconds 1
mkdir -p no_stills
expect 66 'no_stills: holds no stills' "$tool" experiment colours "$courses/forest.toml" --stills no_stills -o colours
expect 69 'nocan0' "$tool" sim "$courses/forest.toml" --devices --config nocan.toml
expect 64 'devices requires --config' "$tool" sim "$courses/forest.toml" --devices
expect 64 'excludes --devices' "$tool" sim "$courses/forest.toml" --devices --record run.lcm
expect 74 'absent/run.lcm' "$tool" sim "$courses/orange_fence.toml" --seconds 1 --record absent/run.lcm
expect 66 'segmentation_default' "$tool" experiment navigation "$courses/forest.toml" -o experiment
expect 66 'segmentation_no_reverse_flow' "$tool" experiment navigation "$courses/forest.toml" --numbers thesis -o experiment
expect 64 'seconds: must be a number above 0, not nan' "$tool" sim "$courses/forest.toml" --seconds nan
expect 64 'starts: must be a number above 0, not 0' "$tool" experiment navigation "$courses/forest.toml" --starts 0 -o experiment
expect 64 'numbers.*default.*thesis' "$tool" experiment navigation "$courses/forest.toml" --numbers other -o experiment

expect 64 'north_m' "$tool" send go-to 1
expect 64 'ADDRESS:PORT' "$tool" send --to nowhere stop
exit $failed
