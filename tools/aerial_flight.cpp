// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/aerial_flight.h"

#include <utility>

namespace hindsight::tools {

AerialFlight::AerialFlight(AerialRenderer& renderer, AerialCamera camera, AerialTraffic traffic,
                           double begin_s)
    : renderer_(renderer),
      camera_(std::move(camera)),
      traffic_(std::move(traffic)),
      time_s_(begin_s),
      flow_({}, AerialCamera::kWidth_px, AerialCamera::kHeight_px) {}

std::span<const FlowVector> AerialFlight::step() {
  shown_s_ = time_s_;
  time_s_ += 1.0 / kFlight_hz;
  frame_ = renderer_.render(camera_, traffic_, shown_s_, shown_++);
  return flow_.update({frame_.bgr.data, frame_.bgr.total() * frame_.bgr.elemSize()});
}

cv::Matx33d AerialFlight::H_image_ground() const { return ground_homography(camera_.projection(shown_s_)); }

}  // namespace hindsight::tools
