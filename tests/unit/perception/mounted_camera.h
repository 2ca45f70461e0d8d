// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The camera of tests on flat ground: 1 m high, looking 0.35 rad down.
#pragma once

#include "perception/camera_model.h"

namespace hindsight {

inline CameraModel mounted_camera() {
  CameraModel camera;
  camera.width_px = 720;
  camera.height_px = 480;
  camera.fx_px = camera.fy_px = 420;
  camera.cx_px = 359.5;
  camera.cy_px = 239.5;
  camera.p_BC_m = {-0.1, 0, 1.0};
  camera.set_orientation(0, 0.35, 0);
  camera.set_field_of_view();
  return camera;
}

}  // namespace hindsight
