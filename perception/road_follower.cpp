// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/road_follower.h"

namespace hindsight {
namespace {

std::variant<ColorRoad, TemplateRoad> make_method(const RoadParams& params, const RoadPicture& picture,
                                                  int history_depth) {
  if (params.method == "templates") return TemplateRoad(params, picture, history_depth);
  return ColorRoad(params, picture, history_depth);
}

}  // namespace

RoadFollower::RoadFollower(const RoadParams& params, const RoadPicture& picture, int history_depth)
    : params_(params), method_(make_method(params, picture, history_depth)) {}

void RoadFollower::reset() {
  std::visit([](auto& method) { method.reset(); }, method_);
  seen_s_ = 0.0;
  estimate_ = {};
}

const RoadEstimate& RoadFollower::update(const RoadInput& input) {
  seen_s_ += input.dt_s;
  std::visit([&](auto& method) { method.update(input, estimate_); }, method_);
  if (seen_s_ < params_.min_history_s) {
    estimate_.status = RoadStatus::short_history;
    estimate_.count = 0;
  }
  return estimate_;
}

}  // namespace hindsight
