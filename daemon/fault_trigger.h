// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "daemon/stop_reason.h"

namespace hindsight {

/// Notices, tick by tick, when a vehicle that might move is stopped by a fault.
class FaultTrigger {
 public:
  /// `decided`: the tick's reason; `reflex`: why the reflex stopped since the tick before. Returns the fault
  /// once, in the tick in which it stops the vehicle; else none.
  StopReason see(StopReason decided, StopReason reflex) {
    StopReason fault = StopReason::none;
    if (is_fault(reflex)) fault = reflex;
    if (is_fault(decided)) fault = decided;
    const bool begins = fault != StopReason::none && might_move_;
    might_move_ = decided == StopReason::none && fault == StopReason::none;
    return begins ? fault : StopReason::none;
  }

 private:
  bool might_move_ = false;
};

}  // namespace hindsight
