// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "perception/camera_model.h"

namespace hindsight {

/// Row of the horizon straight ahead of the vehicle on flat ground; may lie outside of the picture. NaN where
/// the camera does not look ahead at all.
double horizon_row_px(const CameraModel& camera);

}  // namespace hindsight
