// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>

#include "config/params.h"
#include "drivers/samples.h"

namespace hindsight {

struct BackoffParams {
  double first_s = 0.1;
  double longest_s = 2.0;

  void visit(auto&& param) {
    param("reopen_first_s", first_s, Range{0.01, 60.0}, "pause before a failed device is opened again [s]");
    param("reopen_longest_s", longest_s, Range{0.01, 60.0}, "the pause doubles up to this [s]");
  }
};

/// When to try a failed device again: the pause doubles with each failure in a row.
class Backoff {
 public:
  explicit Backoff(const BackoffParams& params)
      : first_(from_seconds(params.first_s)), longest_(from_seconds(params.longest_s)), pause_(first_) {}

  void failed(Time now) {
    next_try_ = now + pause_;
    pause_ = std::min(pause_ * 2, longest_);
  }
  /// The device gives data again.
  void succeeded() { pause_ = first_; }
  /// Zero or less when it is time.
  Time remaining(Time now) const { return next_try_ - now; }

 private:
  Time first_;
  Time longest_;
  Time pause_;
  Time next_try_{};
};

}  // namespace hindsight
