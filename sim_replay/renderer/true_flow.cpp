// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/true_flow.h"

#include <cmath>
#include <limits>

#include "sim_replay/renderer/camera_pose.h"
#include "sim_replay/renderer/lens.h"

namespace hindsight {

TrueFlow::TrueFlow(const RenderCamera& camera) : camera_(camera), lens_(std::make_unique<Lens>(camera)) {}
TrueFlow::~TrueFlow() = default;

FlowTruth TrueFlow::of(const std::vector<float>& depth_m, const BodyPose& X_WB,
                       const BodyPose& X_WB_before) const {
  const CameraPose now = camera_pose(camera_, X_WB), before = camera_pose(camera_, X_WB_before);
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  FlowTruth flow{std::vector<float>(depth_m.size(), kNone), std::vector<float>(depth_m.size(), kNone)};
  for (std::size_t i = 0; i < depth_m.size(); ++i) {
    if (!std::isfinite(depth_m[i])) continue;
    const glm::dvec3 ray(lens_->directions[i].x, lens_->directions[i].y, 1.0);
    const glm::dvec3 p_C = before.to_camera(now.to_world(ray * static_cast<double>(depth_m[i])));
    if (p_C.z <= 0.0) continue;
    const glm::dvec2 px = distorted_px(camera_, {p_C.x / p_C.z, p_C.y / p_C.z});
    flow.u_before_px[i] = static_cast<float>(px.x);
    flow.v_before_px[i] = static_cast<float>(px.y);
  }
  return flow;
}

}  // namespace hindsight
