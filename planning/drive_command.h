// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

namespace hindsight {

/// What planning asks of the wheels: speed of the left and right driven wheel's contact point, forward
/// positive.
struct DriveCommand {
  double left_mps = 0.0;
  double right_mps = 0.0;
  bool operator==(const DriveCommand&) const = default;
};

}  // namespace hindsight
