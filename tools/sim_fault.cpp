// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/sim_fault.h"

#include <cerrno>
#include <utility>

namespace hindsight::tools {

const char* name_of(SimFault fault) {
  constexpr std::array kNames{"none",       "process killed",      "loop hangs",         "CAN bus cut",
                              "CAN silent", "wheel encoders stop", "camera frames stop", "GPIO lines fail",
                              "GPS lost"};
  return kNames[static_cast<std::size_t>(fault)];
}

void FaultInjector::inject(SimFault fault, TickInput& input) {
  switch (fault) {
    case SimFault::bus_cut:
    case SimFault::bus_silent:
      input.can.clear();
      break;
    case SimFault::wheels_off:
      std::erase_if(input.can,
                    [&](const CanFrame& frame) { return decoder_.decode(frame).has(SignalGroup::wheels); });
      break;
    case SimFault::camera_off:
      input.frame = {};
      break;
    case SimFault::lines_failed:
      if (!std::exchange(reported_, true))
        input.reports.push_back({input.now, Source::gpio, SourceState::failed, 0, EIO});
      break;
    case SimFault::gps_off:
      input.fixes.clear();
      break;
    case SimFault::none:
    case SimFault::killed:
    case SimFault::loop_hangs:
      break;
  }
}

}  // namespace hindsight::tools
