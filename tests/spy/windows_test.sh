#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hindsight authors
# SPDX-License-Identifier: BSD-2-Clause
#
# windows_test.sh SOURCE-DIR BUILD-DIR: hindsight-spy decodes our types, and its windows show a grid and a picture: the
# colours that publish_samples puts there are on the screen.
set -euo pipefail
picture=$2/spy/screen.png
SPY_ROWS=4 "$1/tools/spy/screenshot" "$2" "$picture" "$2/publish_samples"

count() { convert "$picture" -fuzz 3% -fill black +opaque "$1" -fill white -opaque "$1" -format '%[fx:int(mean*w*h)]' info:; }
expect() { # COLOUR PIXELS WHAT
  local seen
  seen=$(count "$1")
  echo "$3: $seen pixels of $1"
  if [ "$seen" -lt "$2" ]; then
    echo "FAILED: expected $2 or more; see $picture"
    exit 1
  fi
}
expect '#901010' 70000 "the grid's lethal half"
expect '#2828C8' 18000 "the picture"
expect '#C8C8FF' 50000 "the decoded state's arrays"
