// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// All sums are whole numbers, so that they can be vectorised in any order and come out the same. Grey values
// are held in 1/16, gradients in 1/16 grey level / px: a sum of products over the largest window (13 x 13)
// stays below 2^31.
#include "perception/lucas_kanade.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "perception/multiversion.h"

namespace hindsight {
namespace {

constexpr int kLanes = 16;  // pixels of a window row, used or not: a row is a vector
constexpr int kMaxWindowPx = 13;
constexpr int kUnit = 16;  // of grey values and gradients
constexpr float kProductUnit = kUnit * kUnit;

/// A window's pixels, kLanes a row, and one row more for reads that overhang.
using Patch = std::array<std::int16_t, static_cast<std::size_t>((kMaxWindowPx + 3) * kLanes)>;

using Bytes = std::uint8_t __attribute__((vector_size(kLanes)));
using Words = std::uint16_t __attribute__((vector_size(2 * kLanes)));

HINDSIGHT_ALWAYS_INLINE Bytes load_bytes(const std::uint8_t* p) {
  Bytes bytes;
  std::memcpy(&bytes, p, sizeof(bytes));
  return bytes;
}

/// `rows` rows of kLanes pixels, bilinear, the first one at (x, y), in 1/16 grey level.
HINDSIGHT_ALWAYS_INLINE void sample(const GreyImage& image, float x, float y, int rows, Patch& out) {
  const float floor_x = std::floor(x), floor_y = std::floor(y);
  const float fx = x - floor_x, fy = y - floor_y;
  const auto w11 = static_cast<std::uint16_t>(fx * fy * 128.0F + 0.5F);
  const auto w01 = static_cast<std::uint16_t>(static_cast<int>(fx * 128.0F + 0.5F) - w11);
  const auto w10 = static_cast<std::uint16_t>(static_cast<int>(fy * 128.0F + 0.5F) - w11);
  const auto w00 = static_cast<std::uint16_t>(128 - w01 - w10 - w11);
  const std::uint8_t* p = image.row(static_cast<int>(floor_y)) + static_cast<int>(floor_x);
  std::int16_t* o = out.data();
  Words left = __builtin_convertvector(load_bytes(p), Words),
        right = __builtin_convertvector(load_bytes(p + 1), Words);
  for (int r = 0; r < rows; ++r, o += kLanes) {
    p += image.stride();
    const Words left_below = __builtin_convertvector(load_bytes(p), Words),
                right_below = __builtin_convertvector(load_bytes(p + 1), Words);
    const Words sum = left * w00 + right * w01 + left_below * w10 + right_below * w11 + 4;
    const Words grey = sum >> 3;
    std::memcpy(o, &grey, sizeof(grey));
    left = left_below;
    right = right_below;
  }
}

/// What a level needs to know of the window in the image `from`.
struct Template {
  Patch grey;                                ///< with a border of one pixel
  Patch gx, gy;                              ///< Sobel gradients, zero outside the window
  float inverse_xx, inverse_xy, inverse_yy;  ///< of the gradient matrix
};

HINDSIGHT_ALWAYS_INLINE void compute_gradients(int window_px, Template& t) {
  for (int r = 0; r < window_px; ++r) {
    const std::int16_t* a = t.grey.data() + r * kLanes;
    const std::int16_t* b = a + kLanes;
    const std::int16_t* c = b + kLanes;
    std::int16_t* __restrict gx = t.gx.data() + r * kLanes;
    std::int16_t* __restrict gy = t.gy.data() + r * kLanes;
    for (int i = 0; i < kLanes; ++i) {
      const auto mask = static_cast<std::int16_t>(i < window_px ? -1 : 0);
      const auto x = static_cast<std::int16_t>((a[i + 2] - a[i]) + 2 * (b[i + 2] - b[i]) + (c[i + 2] - c[i]));
      const auto y =
          static_cast<std::int16_t>((c[i] - a[i]) + 2 * (c[i + 1] - a[i + 1]) + (c[i + 2] - a[i + 2]));
      gx[i] = static_cast<std::int16_t>((x >> 3) & mask);
      gy[i] = static_cast<std::int16_t>((y >> 3) & mask);
    }
  }
}

/// With gradients that sum to zero, a brightness that the whole window gained drops out of every product with
/// them.
HINDSIGHT_ALWAYS_INLINE void remove_mean(int window_px, Patch& gradient) {
  const int count = window_px * kLanes;
  int sum = 0;
  for (int i = 0; i < count; ++i) sum += gradient[static_cast<std::size_t>(i)];
  const auto mean = static_cast<std::int16_t>(
      std::lround(static_cast<float>(sum) / static_cast<float>(window_px * window_px)));
  for (int r = 0; r < window_px; ++r) {
    std::int16_t* g = gradient.data() + r * kLanes;
    for (int i = 0; i < kLanes; ++i) g[i] = static_cast<std::int16_t>(g[i] - (i < window_px ? mean : 0));
  }
}

/// False if the window is too smooth in some direction.
HINDSIGHT_ALWAYS_INLINE bool invert_gradient_matrix(int window_px, float min_gradient, Template& t) {
  int sum_xx = 0, sum_xy = 0, sum_yy = 0;
  for (int i = 0; i < window_px * kLanes; ++i) {
    const auto n = static_cast<std::size_t>(i);
    sum_xx += t.gx[n] * t.gx[n];
    sum_xy += t.gx[n] * t.gy[n];
    sum_yy += t.gy[n] * t.gy[n];
  }
  const float xx = static_cast<float>(sum_xx), xy = static_cast<float>(sum_xy),
              yy = static_cast<float>(sum_yy);
  const float smaller_eigenvalue = 0.5F * ((xx + yy) - std::sqrt((xx - yy) * (xx - yy) + 4.0F * xy * xy));
  const float pixels = static_cast<float>(window_px * window_px);
  const float determinant = xx * yy - xy * xy;
  if (!(smaller_eigenvalue > min_gradient * min_gradient * kProductUnit * pixels) || !(determinant > 0.0F)) {
    return false;
  }
  t.inverse_xx = yy / determinant;
  t.inverse_xy = -xy / determinant;
  t.inverse_yy = xx / determinant;
  return true;
}

/// The step from the guess, whose window is `grey`, towards the match.
HINDSIGHT_ALWAYS_INLINE Point2f solve_step(const Template& t, const Patch& grey, int window_px) {
  int bx = 0, by = 0;
  for (int r = 0; r < window_px; ++r) {
    const std::int16_t* wanted = t.grey.data() + (r + 1) * kLanes + 1;
    const std::int16_t* found = grey.data() + r * kLanes;
    const std::int16_t* gx = t.gx.data() + r * kLanes;
    const std::int16_t* gy = t.gy.data() + r * kLanes;
    for (int i = 0; i < kLanes; ++i) {
      const auto difference = static_cast<std::int16_t>(wanted[i] - found[i]);
      bx += gx[i] * difference;
      by += gy[i] * difference;
    }
  }
  const float x = static_cast<float>(bx), y = static_cast<float>(by);
  return {t.inverse_xx * x + t.inverse_xy * y, t.inverse_xy * x + t.inverse_yy * y};
}

/// A rectangle of positions.
struct Bounds {
  Point2f least;
  Point2f most;
  bool contains(Point2f p) const {
    return p.x_px >= least.x_px && p.y_px >= least.y_px && p.x_px <= most.x_px && p.y_px <= most.y_px;
  }
};

HINDSIGHT_ALWAYS_INLINE Bounds bounds_of(const GreyImage& image, float margin) {
  return {{-margin, -margin},
          {static_cast<float>(image.width_px() - 1) + margin,
           static_cast<float>(image.height_px() - 1) + margin}};
}

/// The positions of the image that are at most `most_px` away in x and in y.
HINDSIGHT_ALWAYS_INLINE Bounds bounds_around(Point2f p, float most_px, const Bounds& image) {
  return {{std::max(image.least.x_px, p.x_px - most_px), std::max(image.least.y_px, p.y_px - most_px)},
          {std::min(image.most.x_px, p.x_px + most_px), std::min(image.most.y_px, p.y_px + most_px)}};
}

enum class OnLevel { matched, too_smooth, lost };

/// Moves `guess` to the match of `point` on one level.
HINDSIGHT_ALWAYS_INLINE OnLevel track_on_level(const TrackerParams& params, const GreyImage& from,
                                               const GreyImage& to, Point2f point, Point2f& guess,
                                               Template& t, Patch& grey) {
  const int window_px = params.window_px;
  const auto reach = static_cast<float>(window_px / 2);
  const auto stop = static_cast<float>(params.stop_step_px * params.stop_step_px);
  sample(from, point.x_px - reach - 1.0F, point.y_px - reach - 1.0F, window_px + 2, t.grey);
  compute_gradients(window_px, t);
  if (params.remove_mean) {
    remove_mean(window_px, t.gx);
    remove_mean(window_px, t.gy);
  }
  if (!invert_gradient_matrix(window_px, static_cast<float>(params.min_gradient), t))
    return OnLevel::too_smooth;
  const Bounds bounds = bounds_around(guess, static_cast<float>(params.max_move_px), bounds_of(to, reach));
  for (int i = 0; i < params.max_iterations; ++i) {
    if (!bounds.contains(guess)) return OnLevel::lost;
    sample(to, guess.x_px - reach, guess.y_px - reach, window_px, grey);
    const Point2f step = solve_step(t, grey, window_px);
    guess = {guess.x_px + step.x_px, guess.y_px + step.y_px};
    if (step.x_px * step.x_px + step.y_px * step.y_px < stop) break;
  }
  return bounds.contains(guess) ? OnLevel::matched : OnLevel::lost;
}

HINDSIGHT_ALWAYS_INLINE TrackedPoint track_point(const TrackerParams& params, const ImagePyramid& from,
                                                 const ImagePyramid& to, int levels, Point2f point,
                                                 Point2f guess, Template& t, Patch& grey) {
  float scale = 1.0F / static_cast<float>(1 << (levels - 1));
  Point2f match{guess.x_px * scale, guess.y_px * scale};
  for (int level = levels - 1; level >= 0; --level, scale *= 2.0F) {
    const Point2f here{point.x_px * scale, point.y_px * scale};
    const OnLevel outcome = track_on_level(params, from.level(level), to.level(level), here, match, t, grey);
    // A smooth coarse window leaves the guess to the finer ones; a match that ran away does not come back.
    if (outcome == OnLevel::lost || (outcome == OnLevel::too_smooth && level == 0)) return {};
    if (level > 0) match = {2.0F * match.x_px, 2.0F * match.y_px};
  }
  return {match, bounds_of(to.level(0), 0.0F).contains(match)};
}

}  // namespace

HINDSIGHT_MULTIVERSION
void track_points(const TrackerParams& params, const ImagePyramid& from, const ImagePyramid& to, int levels,
                  std::span<const Point2f> points_px, std::span<const Point2f> guesses_px,
                  std::span<TrackedPoint> tracked) {
  Template t{};
  Patch grey{};
  for (std::size_t i = 0; i < points_px.size(); ++i) {
    tracked[i] = track_point(params, from, to, levels, points_px[i], guesses_px[i], t, grey);
  }
}

}  // namespace hindsight
