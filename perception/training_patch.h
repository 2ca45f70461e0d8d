// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The pixels that a training event trains on: those of its patch, each traced back on its own along stored
// reverse flow to where it was first seen (thesis 5.1).
//
// How far back is enough? The thesis goes to where a point entered the view, or to the oldest frame held. A
// patch that came from afar was smaller than a pixel there, so "size" stops while it is still min_width_px
// wide.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "config/params.h"
#include "perception/appearance_history.h"
#include "perception/camera_model.h"

namespace hindsight {

struct TrainingPatchParams {
  bool reverse_flow = true;
  std::string trace_until = "size";
  double min_width_px = 8.0;
  int max_points = 400;

  void visit(auto&& param) {
    param("reverse_flow", reverse_flow, YesNo{}, "false: train on patches as they look now, for comparison");
    param("trace_until", trace_until, Choices{"size", "oldest"},
          "how far back: while the patch is min_width_px wide, or as far as is stored (the thesis)");
    param("min_width_px", min_width_px, Range{1.0, 1000.0},
          "least width of a patch in the frame trained on [px]");
    param("max_points", max_points, Range{1, 1000000}, "points of a patch that are traced, evenly spread");
  }
};

/// What came of a patch, for telemetry and pictures.
struct TracedPatch {
  int points = 0;       ///< traced
  int pixels = 0;       ///< different stored pixels that they ended on
  int frames_back = 0;  ///< the frame in which the patch's middle ended
  ImageRect there_px;   ///< around the points that ended in that frame
};

/// Holds the scratch memory. One thread.
class TrainingPatchTracer {
 public:
  explicit TrainingPatchTracer(const TrainingPatchParams& params);

  /// Sets `pixels` to those that patch_px, a region of the frame `frames_back` before the newest, teaches: no
  /// stored pixel twice. Empty where the frame is no longer held. No allocation once `pixels` has room for
  /// max_points.
  ///
  /// Flow: a FlowHistory, or whatever has its trace_back(point, max_frames, from_frames_back).
  template <typename Flow>
  TracedPatch trace(const Flow& flow, const AppearanceHistory& appearance, const ImageRect& patch_px,
                    int frames_back, std::vector<Bgr>& pixels);

 private:
  /// Distance between the points of a patch that are traced, so that there are at most max_points.
  float spacing_px(const ImageRect& patch_px) const;
  void end_at(const AppearanceHistory& appearance, float x_px, float y_px, int frames_back);
  void take_pixels(const AppearanceHistory& appearance, std::vector<Bgr>& pixels);
  /// Frames over which the patch stays wide enough.
  template <typename Flow>
  int frames_while_wide(const Flow& flow, const ImageRect& patch_px, int frames_back, int most) const;

  TrainingPatchParams params_;
  std::vector<std::uint64_t>
      stored_;  ///< stored pixels hit: frames_back in the upper half, index in the lower
};

/// A box that grows around points.
class PointBox {
 public:
  void add(float x_px, float y_px) {
    left_ = std::min(left_, x_px), right_ = std::max(right_, x_px);
    top_ = std::min(top_, y_px), bottom_ = std::max(bottom_, y_px);
  }
  ImageRect rect() const {
    return left_ > right_ ? ImageRect{}
                          : ImageRect{left_, top_, right_ - left_ + 1.0F, bottom_ - top_ + 1.0F};
  }

 private:
  float left_ = 1e9F, right_ = -1e9F, top_ = 1e9F, bottom_ = -1e9F;
};

template <typename Flow>
int TrainingPatchTracer::frames_while_wide(const Flow& flow, const ImageRect& patch_px, int frames_back,
                                           int most) const {
  const float middle_y = patch_px.y_px + patch_px.height_px / 2 - 0.5F;
  decltype(flow.trace_back({}, 0, 0).point_px) left{patch_px.x_px - 0.5F, middle_y};
  auto right = left;
  right.x_px += patch_px.width_px;
  for (int n = 1; n <= most; ++n) {
    const auto l = flow.trace_back(left, 1, frames_back + n - 1),
               r = flow.trace_back(right, 1, frames_back + n - 1);
    if (l.frames_back < frames_back + n || r.frames_back < frames_back + n)
      return most;  // an edge entered the view
    left = l.point_px, right = r.point_px;
    if (std::hypot(right.x_px - left.x_px, right.y_px - left.y_px) < static_cast<float>(params_.min_width_px))
      return n - 1;
  }
  return most;
}

template <typename Flow>
TracedPatch TrainingPatchTracer::trace(const Flow& flow, const AppearanceHistory& appearance,
                                       const ImageRect& patch_px, int frames_back, std::vector<Bgr>& pixels) {
  pixels.clear();
  TracedPatch result;
  int most = params_.reverse_flow ? appearance.size() - 1 - frames_back : 0;
  if (frames_back < 0 || frames_back >= appearance.size()) return result;
  if (params_.trace_until == "size" && most > 0) most = frames_while_wide(flow, patch_px, frames_back, most);

  const float middle_x = patch_px.x_px + patch_px.width_px / 2 - 0.5F,
              middle_y = patch_px.y_px + patch_px.height_px / 2 - 0.5F;
  result.frames_back = flow.trace_back({middle_x, middle_y}, most, frames_back).frames_back;
  PointBox there;
  stored_.clear();
  const float step = spacing_px(patch_px);
  for (float y = patch_px.y_px + step / 2; y < patch_px.y_px + patch_px.height_px; y += step) {
    for (float x = patch_px.x_px + step / 2; x < patch_px.x_px + patch_px.width_px; x += step) {
      const auto end = flow.trace_back({x - 0.5F, y - 0.5F}, most, frames_back);
      end_at(appearance, end.point_px.x_px, end.point_px.y_px, end.frames_back);
      if (end.frames_back == result.frames_back) there.add(end.point_px.x_px, end.point_px.y_px);
      ++result.points;
    }
  }
  take_pixels(appearance, pixels);
  result.pixels = static_cast<int>(pixels.size());
  result.there_px = there.rect();
  return result;
}

}  // namespace hindsight
