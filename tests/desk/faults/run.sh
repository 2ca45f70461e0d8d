#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hindsight authors
# SPDX-License-Identifier: BSD-2-Clause
#
# run.sh GROUP SOURCE-DIR BUILD-DIR: a group of faults on the vehicle on a desk (GROUP.sh, in the guest), in virtual time;
# then what it recorded is run again here, and must publish the same.
set -euo pipefail
group=$1
source=$2
build=$3
here=$(cd "$(dirname "$0")" && pwd)
work=$build/desk/faults_$group
rm -rf "$work"
mkdir -p "$work"
"$here/../boot" -v -o "$work" -t 500 "$here/$group.sh" "$source" "$build"
if [ -f "$work/run.lcm" ]; then "$build/hindsight" verify "$work/run.lcm"; fi
if [ -f "$work/flight.lcm" ]; then
  "$build/hindsightd" --replay "$work/flight.lcm"
  if "$build/hindsight" verify "$work/flight.lcm"; then
    echo "FAILED: a log that begins in the middle of a run verifies"
    exit 1
  fi
  echo "ok: the flight recorder's log replays"
fi
