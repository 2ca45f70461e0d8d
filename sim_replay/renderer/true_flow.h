// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>
#include <vector>

#include "sim_replay/renderer/renderer.h"

namespace hindsight {

/// For each pixel of a frame, row by row: where that point of the scene was in the frame before, in pixels;
/// it may lie outside of the picture. NaN: sky, or behind the camera then.
struct FlowTruth {
  std::vector<float> u_before_px;
  std::vector<float> v_before_px;
};

struct Lens;

/// True optical flow of a scene in which only the camera moves, from its depth and both poses.
class TrueFlow {
 public:
  explicit TrueFlow(const RenderCamera& camera);
  ~TrueFlow();
  /// depth_m: of the frame at X_WB, as RenderedFrame has it.
  FlowTruth of(const std::vector<float>& depth_m, const BodyPose& X_WB, const BodyPose& X_WB_before) const;

 private:
  RenderCamera camera_;
  std::unique_ptr<Lens> lens_;
};

}  // namespace hindsight
