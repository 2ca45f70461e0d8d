// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "daemon/reflex.h"
#include "daemon/robot_config.h"

namespace hindsight {

/// The reflex of a run that has none of its own in the log: the same class, driven in the samples' time. Used for
/// imported recordings and by the simulator.
class VirtualReflex {
 public:
  explicit VirtualReflex(const Configuration& configuration);

  /// Runs up to input.now, seeing the edges of `input`, and fills in input.reflex.
  void run_up_to(TickInput& input);
  /// What the loop decided in the tick just run.
  void decide(const Decision& decision) { board_.decision.write(decision); }

 private:
  void step(Time now);

  Reflex reflex_;
  ReflexBoard board_;
  Time period_;
  Time next_{};
  ReflexReport report_;
};

}  // namespace hindsight
