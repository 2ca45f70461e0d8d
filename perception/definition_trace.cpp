// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/definition_trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "config/exit_code.h"

namespace hindsight {
namespace {

/// A strip narrower than this shows nothing any more.
constexpr float kNarrowest_px = 6.0F;
constexpr std::size_t kMostStrips = 32;

}  // namespace

RoadStrip definition_region(const RoadParams& params, const RoadPicture& picture) {
  const double half = 0.5 * params.definition_width;
  const double bottom_px = params.definition_bottom * picture.height_px;
  const RoadStrip strip{static_cast<float>((params.definition_centre - half) * picture.width_px),
                        static_cast<float>((params.definition_centre + half) * picture.width_px),
                        static_cast<float>(bottom_px - params.definition_height_px), 0};
  const bool fits = strip.left_px >= 0.0F && strip.right_px <= static_cast<float>(picture.width_px) &&
                    strip.top_px >= 0.0F && strip.width_px() >= kNarrowest_px;
  if (!fits) {
    throw FatalError(
        kExitConfiguration,
        fmt::format(
            "road: the definition region, columns {:.0f} to {:.0f}, rows {:.0f} to {:.0f}, does not lie in "
            "the picture of {} x {} px",
            strip.left_px, strip.right_px, strip.top_px, bottom_px, picture.width_px, picture.height_px));
  }
  return strip;
}

DefinitionTrace::DefinitionTrace(const RoadParams& params, const RoadPicture& picture, int history_depth)
    : region_(definition_region(params, picture)),
      height_px_(static_cast<float>(params.definition_height_px)),
      picture_width_px_(static_cast<float>(picture.width_px)) {
  all_.reserve(static_cast<std::size_t>(history_depth));
  chosen_.reserve(kMostStrips);
}

std::span<const RoadStrip> DefinitionTrace::trace(const FlowHistory& history, int count) {
  all_.clear();
  chosen_.clear();
  // The middle of each side, frame by frame.
  Point2f left{region_.left_px, region_.top_px + 0.5F * height_px_};
  Point2f right{std::min(region_.right_px, picture_width_px_ - 1.0F), left.y_px};
  for (int back = 1; back <= history.size(); ++back) {
    const FlowHistory::Trace l = history.trace_back(left, 1, back - 1);
    const FlowHistory::Trace r = history.trace_back(right, 1, back - 1);
    if (l.frames_back != back || r.frames_back != back) break;
    left = l.point_px;
    right = r.point_px;
    if (right.x_px - left.x_px < kNarrowest_px) break;
    all_.push_back({left.x_px, right.x_px, 0.5F * (left.y_px + right.y_px) - 0.5F * height_px_, back});
  }
  if (all_.empty()) return {};
  const auto higher = [](const RoadStrip& a, const RoadStrip& b) { return a.top_px < b.top_px; };
  const float first = all_.front().top_px, last = std::min_element(all_.begin(), all_.end(), higher)->top_px;
  for (int i = 0; i < count; ++i) {
    const float wanted =
        first + (last - first) * static_cast<float>(i) / static_cast<float>(std::max(count - 1, 1));
    const auto nearest =
        std::min_element(all_.begin(), all_.end(), [wanted](const RoadStrip& a, const RoadStrip& b) {
          return std::abs(a.top_px - wanted) < std::abs(b.top_px - wanted);
        });
    if (chosen_.empty() || nearest->frames_back > chosen_.back().frames_back) chosen_.push_back(*nearest);
  }
  return chosen_;
}

}  // namespace hindsight
