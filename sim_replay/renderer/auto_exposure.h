// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace hindsight {

/// Automatic exposure and gain that follow the mean of the pictures with a lag, as cameras do: longer
/// exposure first, gain where that is not enough.
class AutoExposure {
 public:
  /// As if it had looked at this picture long enough. mean: of the green bytes.
  void settle(double mean);
  void meter(double mean, double dt_s);

  float exposure_s() const;
  float gain() const;

 private:
  double stops_ = -10.0;  ///< log2 of exposure times gain [s]; at first, as for a sunny day
};

/// Mean of the green bytes of a sparse raster over the lower three fifths: a camera that looks at the ground
/// is set up not to meter the sky.
double mean_green(const std::vector<std::uint8_t>& bgr);

}  // namespace hindsight
