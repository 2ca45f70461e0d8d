// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/slip_watch.h"

namespace hindsight {

void SlipWatch::add_currents(Time stamp, double left_a, double right_a) {
  currents_.add_current(Wheel::left, stamp, left_a);
  currents_.add_current(Wheel::right, stamp, right_a);
}

bool SlipWatch::update(Time now, const std::array<WheelMotion, kWheelCount>& motion) {
  const SlipReport& by_currents = currents_.update(now, motion);
  const GroundSlipReport& by_ground = ground_.update(now, motion);
  for (std::size_t i = 0; i < kWheelCount; ++i)
    slipping_[i] = by_ground.known ? by_ground.wheels[i].slipping : by_currents.wheels[i].slipping;
  return slipping();
}

}  // namespace hindsight
