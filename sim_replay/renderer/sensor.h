// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "sim_replay/renderer/auto_exposure.h"
#include "sim_replay/renderer/camera_pose.h"
#include "sim_replay/renderer/gl_program.h"
#include "sim_replay/renderer/gl_target.h"
#include "sim_replay/renderer/lens.h"

namespace hindsight {

/// From the light of the wide picture to the camera's bytes.
class Sensor {
 public:
  Sensor(const RenderCamera& camera, const Lens& lens, std::uint64_t seed);

  struct Motion {
    CameraPose now, before;
    double interval_s = 0.1;
  };
  /// Exposes with what the meter says, then lets it see the result.
  void take(const GlImage& light, const GlImage& depth, const Motion& motion, std::vector<std::uint8_t>& bgr);

  float exposure_s() const { return exposure_s_; }
  float gain() const { return gain_; }

 private:
  void expose(const GlImage& light, const GlImage& depth, const Motion& motion,
              std::vector<std::uint8_t>& bgr);

  int width_px_, height_px_;
  WidePinhole wide_;
  GlProgram program_;
  GlImage sources_, picture_;
  GlTarget target_;
  AutoExposure meter_;
  std::vector<std::uint8_t> rgba_;
  std::uint32_t frame_;
  bool settled_ = false;
  float exposure_s_ = 0.0F, gain_ = 1.0F;
};

}  // namespace hindsight
