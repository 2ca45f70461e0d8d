// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/stop_watch.h"

#include <cmath>

namespace hindsight::tools {

void StopWatch::see(Time now, double speed_mps, double way_m, const std::optional<WheelCommand>& command) {
  const double after_s = to_seconds(now - began_);
  const bool zero = !command || (command->left_mps == 0.0 && command->right_mps == 0.0);
  if (!zero) zero_s_.reset();
  if (zero && !zero_s_) zero_s_ = after_s;
  const bool stands = std::abs(speed_mps) < kStands_mps;
  if (!stands) stand_s_.reset();
  if (!stand_s_) rolled_m_ = way_m - began_m_;
  if (stands && !stand_s_) stand_s_ = after_s;
}

}  // namespace hindsight::tools
