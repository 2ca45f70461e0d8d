// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

namespace hindsight {

/// A point of an image: origin top left, x right, y down; pixel centres lie at whole numbers.
struct Point2f {
  float x_px = 0.0F;
  float y_px = 0.0F;
};

/// Reverse optical flow at one point: it lies at (x, y) in the newest frame t and lay at (x + dx, y + dy) in
/// frame t-1.
struct FlowVector {
  float x_px = 0.0F;
  float y_px = 0.0F;
  float dx_px = 0.0F;
  float dy_px = 0.0F;
};

}  // namespace hindsight
