// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The pixels that a training event trains on: those of its patch, each traced back on its own along stored
// reverse flow to where it was first seen (thesis 5.1).
//
// How far back is enough? The thesis goes to where a point entered the view, or to the oldest frame held. A
// patch that came from afar was smaller than a pixel there, so "size" stops while it is still min_width_px
// wide. And what of the way there? The thesis trains on the far end alone, which unlearns how things look
// from nearby; "all" trains on the patch as it grew, each look look_ratio as wide as the next nearer one.
#pragma once

#include <algorithm>
#include <array>
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
  std::string looks = "all";
  double look_ratio = 0.7;
  double min_width_px = 8.0;
  int max_points = 100;

  void visit(auto&& param) {
    param("reverse_flow", reverse_flow, YesNo{}, "false: train on patches as they look now, for comparison");
    param("trace_until", trace_until, Choices{"size", "oldest"},
          "how far back: while the patch is min_width_px wide, or as far as is stored (the thesis)");
    param("looks", looks, Choices{"all", "far"},
          "what is trained on: the patch from near to far, or its far end alone (the thesis)");
    param("look_ratio", look_ratio, Range{0.1, 0.95}, "width of a look, over that of the next nearer one");
    param("min_width_px", min_width_px, Range{1.0, 1000.0},
          "least width of a patch in the frame trained on [px]");
    param("max_points", max_points, Range{1, 1000000},
          "points of a patch that are traced, evenly spread: near looks are to weigh no more than far ones");
  }
};

/// What came of a patch, for telemetry and pictures.
struct TracedPatch {
  int points = 0;       ///< traced
  int pixels = 0;       ///< different stored pixels that they came by and that are trained on
  int frames_back = 0;  ///< the frame in which the patch's middle ended
  ImageRect there_px;   ///< around the points that ended in that frame
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

/// Stored pixels: how each looks, and the texture around it.
struct PatchPixels {
  std::vector<Bgr> bgr;
  std::vector<std::uint8_t> texture;  ///< texture_code_at, one for one

  void reserve(std::size_t pixels) { bgr.reserve(pixels), texture.reserve(pixels); }
  void clear() { bgr.clear(), texture.clear(); }
};

/// Holds the scratch memory. One thread.
class TrainingPatchTracer {
 public:
  explicit TrainingPatchTracer(const TrainingPatchParams& params);

  /// Stored pixels that one patch may teach at most.
  std::size_t capacity() const { return stored_.capacity(); }

  /// Sets `pixels` to those that patch_px, a region of the frame `frames_back` before the newest, teaches: no
  /// stored pixel twice. Empty where the frame is no longer held. No allocation once `pixels` has room for
  /// capacity().
  ///
  /// Flow: a FlowHistory, or whatever has its trace_back(point, max_frames, from_frames_back).
  template <typename Flow>
  TracedPatch trace(const Flow& flow, const AppearanceHistory& appearance, const ImageRect& patch_px,
                    int frames_back, PatchPixels& pixels);

 private:
  static constexpr std::size_t kMostLooks = 16;
  /// How many frames before the patch's own one it is looked at, rising. At least one.
  struct Looks {
    std::array<int, kMostLooks> frames{};
    std::size_t count = 0;

    void add(int n) {
      if (count < kMostLooks) frames[count++] = n;
    }
  };

  /// Distance between the points of a patch that are traced, so that there are at most max_points.
  float spacing_px(const ImageRect& patch_px) const;
  bool end_at(const AppearanceHistory& appearance, float x_px, float y_px, int frames_back);
  void take_pixels(const AppearanceHistory& appearance, PatchPixels& pixels);
  template <typename Flow>
  Looks plan_looks(const Flow& flow, const ImageRect& patch_px, int frames_back, int most) const;
  template <typename Flow>
  void trace_point(const Flow& flow, const AppearanceHistory& appearance, float x_px, float y_px,
                   int frames_back, const Looks& looks, int middle_frames_back);

  TrainingPatchParams params_;
  PointBox there_;
  std::vector<std::uint64_t>
      stored_;  ///< stored pixels hit: frames_back in the upper half, index in the lower
};

/// Follows the patch's left and right edge back as long as it is wide enough, or as it is in view.
template <typename Flow>
TrainingPatchTracer::Looks TrainingPatchTracer::plan_looks(const Flow& flow, const ImageRect& patch_px,
                                                           int frames_back, int most) const {
  Looks looks;
  const bool all = params_.looks == "all", until_small = params_.trace_until == "size";
  const float middle_y = patch_px.y_px + patch_px.height_px / 2 - 0.5F;
  decltype(flow.trace_back({}, 0, 0).point_px) left{patch_px.x_px - 0.5F, middle_y};
  auto right = left;
  right.x_px += patch_px.width_px;
  float last_width_px = patch_px.width_px;
  int wide = all || until_small ? 0 : most;
  if (all) looks.add(0);
  for (int n = 1; n <= most && wide < most; ++n) {
    const auto l = flow.trace_back(left, 1, frames_back + n - 1),
               r = flow.trace_back(right, 1, frames_back + n - 1);
    if (l.frames_back < frames_back + n || r.frames_back < frames_back + n) {  // an edge entered the view
      if (!all) wide = most;
      break;
    }
    left = l.point_px, right = r.point_px;
    const float width_px = std::hypot(right.x_px - left.x_px, right.y_px - left.y_px);
    if (until_small && width_px < static_cast<float>(params_.min_width_px)) break;
    wide = n;
    if (all && width_px <= static_cast<float>(params_.look_ratio) * last_width_px) {
      looks.add(n);
      last_width_px = width_px;
    }
  }
  if (!all) looks.add(wide);
  return looks;
}

/// From look to look, to the last, or to where the point entered the view.
template <typename Flow>
void TrainingPatchTracer::trace_point(const Flow& flow, const AppearanceHistory& appearance, float x_px,
                                      float y_px, int frames_back, const Looks& looks,
                                      int middle_frames_back) {
  auto at = flow.trace_back({x_px, y_px}, 0, frames_back);
  for (std::size_t k = 0; k < looks.count; ++k) {
    const int wanted = frames_back + looks.frames[k];
    at = flow.trace_back(at.point_px, wanted - at.frames_back, at.frames_back);
    if (!end_at(appearance, at.point_px.x_px, at.point_px.y_px, at.frames_back)) return;
    if (at.frames_back < wanted) break;
  }
  if (at.frames_back == middle_frames_back) there_.add(at.point_px.x_px, at.point_px.y_px);
}

template <typename Flow>
TracedPatch TrainingPatchTracer::trace(const Flow& flow, const AppearanceHistory& appearance,
                                       const ImageRect& patch_px, int frames_back, PatchPixels& pixels) {
  pixels.clear();
  TracedPatch result;
  if (frames_back < 0 || frames_back >= appearance.size()) return result;
  const int most = params_.reverse_flow ? appearance.size() - 1 - frames_back : 0;
  const Looks looks = plan_looks(flow, patch_px, frames_back, most);
  const float middle_x = patch_px.x_px + patch_px.width_px / 2 - 0.5F,
              middle_y = patch_px.y_px + patch_px.height_px / 2 - 0.5F;
  result.frames_back =
      flow.trace_back({middle_x, middle_y}, looks.frames[looks.count - 1], frames_back).frames_back;
  there_ = {};
  stored_.clear();
  const float step = spacing_px(patch_px);
  for (float y = patch_px.y_px + step / 2; y < patch_px.y_px + patch_px.height_px; y += step) {
    for (float x = patch_px.x_px + step / 2; x < patch_px.x_px + patch_px.width_px; x += step) {
      trace_point(flow, appearance, x - 0.5F, y - 0.5F, frames_back, looks, result.frames_back);
      ++result.points;
    }
  }
  take_pixels(appearance, pixels);
  result.pixels = static_cast<int>(pixels.bgr.size());
  result.there_px = there_.rect();
  return result;
}

}  // namespace hindsight
