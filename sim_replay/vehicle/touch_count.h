// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>

namespace hindsight {

/// Counts what the experiments call a touch: a bumper that closes, or something nearer than an IR sensor's
/// threshold that no bumper met, once for each approach.
class TouchCount {
 public:
  explicit TouchCount(double ir_threshold_m) : ir_threshold_m_(ir_threshold_m) {}

  void see(const std::array<bool, 2>& bumpers);
  void see_ir(double left_m, double right_m);

  int bumper() const { return bumper_; }
  int ir() const { return ir_ + (near_ && !met_ ? 1 : 0); }

 private:
  /// An approach ends when everything is farther than the threshold and this.
  static constexpr double kHysteresis_m = 0.2;

  double ir_threshold_m_;
  bool pressed_ = false;
  bool near_ = false;
  bool met_ = false;  ///< a bumper closed during the present approach
  int bumper_ = 0;
  int ir_ = 0;
};

}  // namespace hindsight
