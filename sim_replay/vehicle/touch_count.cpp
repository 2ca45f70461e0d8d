// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/vehicle/touch_count.h"

#include <algorithm>

namespace hindsight {

void TouchCount::see(const std::array<bool, 2>& bumpers) {
  const bool pressed = bumpers[0] || bumpers[1];
  if (pressed && !pressed_) ++bumper_;
  met_ = met_ || pressed;
  pressed_ = pressed;
}

void TouchCount::see_ir(double left_m, double right_m) {
  const double nearest_m = std::min(left_m, right_m);
  if (!near_ && nearest_m < ir_threshold_m_) {
    near_ = true;
    met_ = pressed_;
  } else if (near_ && nearest_m > ir_threshold_m_ + kHysteresis_m && !pressed_) {
    if (!met_) ++ir_;
    near_ = false;
  }
}

}  // namespace hindsight
