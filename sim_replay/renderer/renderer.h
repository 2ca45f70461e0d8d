// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The camera's view of a World, rendered with OpenGL (no display or GPU needed), and the truth about each
// pixel. Things look different from afar because textures blur, light falls at other angles, haze lies
// between and the sensor has its limits, never because anything changes their colour.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "sim_replay/world/world.h"

namespace hindsight {

/// Pinhole with OpenCV's distortion, mounted on the body. C: x right, y down, z forward; B: forward, left,
/// up.
struct RenderCamera {
  int width_px = 720;
  int height_px = 480;
  double fx_px = 420.0;
  double fy_px = 420.0;
  double cx_px = 359.5;
  double cy_px = 239.5;
  std::array<double, 8> distortion{};  ///< k1 k2 p1 p2 k3 k4 k5 k6
  std::array<double, 9> R_BC{};        ///< row by row
  std::array<double, 3> p_BC_m{};
};

/// Arrays go row by row without padding.
struct RenderedFrame {
  std::vector<std::uint8_t> bgr;
  float exposure_s = 0.0F;
  float gain = 1.0F;

  // The truth; empty unless asked for.
  std::vector<TruthLabel> labels;      ///< road: on a trail
  std::vector<std::uint16_t> objects;  ///< 0: none; else 1 + index over trees, then bushes, rocks, fences
  std::vector<float> depth_m;          ///< along the optical axis; infinity: sky
};

/// One thread at a time may use it. The same calls give the same bytes on one type of CPU, with any number of
/// rendering threads (LP_NUM_THREADS).
class Renderer {
 public:
  /// seed: of the sensor's noise. FatalError(kExitNoDevice) that says "no EGL" where there is none.
  Renderer(const World& world, const RenderCamera& camera, std::uint64_t seed);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// The next frame; noise and exposure go on from the frame before. X_WB_before: where the body was
  /// frame_interval_s ago, for motion blur. time_s: of the clouds. The frame stays valid until the next call.
  const RenderedFrame& render(const BodyPose& X_WB, const BodyPose& X_WB_before, double frame_interval_s,
                              double time_s, bool truth);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hindsight
