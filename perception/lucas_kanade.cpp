// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// All sums are whole numbers, so that they can be vectorised in any order and come out the same. Grey values
// are held in 1/16, gradients in 1/16 grey level / px: a sum of products over the largest window (13 x 13)
// stays below 2^31.
#include "perception/lucas_kanade.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "perception/multiversion.h"

namespace hindsight {
namespace {

constexpr int kUnit = 16;  // of grey values and gradients
constexpr float kProductUnit = kUnit * kUnit;

/// Eight pixels of a row; wider windows take two of them, and what lies outside of the window counts nothing.
constexpr std::size_t kLanes = 8;
using Words = std::uint16_t __attribute__((vector_size(16)));
using Pixels = std::int16_t __attribute__((vector_size(16)));
using Sums = std::int32_t __attribute__((vector_size(16)));
constexpr std::size_t vectors_for(std::size_t window_px) { return (window_px + kLanes - 1) / kLanes; }

HINDSIGHT_ALWAYS_INLINE void load_words(Words& words, const std::uint8_t* p) {
  using Bytes = std::uint8_t __attribute__((vector_size(16)));
  using Halves = std::uint64_t __attribute__((vector_size(16)));
  std::uint64_t eight;
  std::memcpy(&eight, p, sizeof(eight));
  words = Words(__builtin_shuffle(Bytes(Halves{eight, 0}), Bytes{},
                                  Bytes{0, 16, 1, 16, 2, 16, 3, 16, 4, 16, 5, 16, 6, 16, 7, 16}));
  static_assert(std::endian::native == std::endian::little, "the low byte comes first");
}

/// Adds the products of neighbours in pairs: one instruction on x86.
HINDSIGHT_ALWAYS_INLINE void add_products(Sums& sums, const Pixels& a, const Pixels& b) {
#ifdef __SSE2__
  sums += Sums(__builtin_ia32_pmaddwd128(a, b));
#else
  Sums x, y;
  std::memcpy(&x, &a, sizeof(x));
  std::memcpy(&y, &b, sizeof(y));
  sums += ((x << 16) >> 16) * ((y << 16) >> 16) + (x >> 16) * (y >> 16);
#endif
}

HINDSIGHT_ALWAYS_INLINE int total(const Sums& sums) { return (sums[0] + sums[1]) + (sums[2] + sums[3]); }

/// The totals of two at once: half the instructions, and those of short delay.
HINDSIGHT_ALWAYS_INLINE Point2f totals(const Sums& a, const Sums& b) {
  const Sums halves = __builtin_shuffle(a, b, Sums{0, 4, 1, 5}) + __builtin_shuffle(a, b, Sums{2, 6, 3, 7});
  const Sums whole = halves + __builtin_shuffle(halves, Sums{2, 3, 0, 1});
  return {static_cast<float>(whole[0]), static_cast<float>(whole[1])};
}

/// All bits where pixel v * kLanes + lane belongs to a window's row.
HINDSIGHT_ALWAYS_INLINE void mark_inside(std::size_t window_px, std::size_t v, Pixels& mask) {
  constexpr Pixels kPlaces{0, 1, 2, 3, 4, 5, 6, 7};
  mask = kPlaces + static_cast<std::int16_t>(v * kLanes) < static_cast<std::int16_t>(window_px);
}

/// Rows of an image from (x, y) down, bilinear, in 1/16 grey level.
template <std::size_t kVectors>
class RowSampler {
 public:
  HINDSIGHT_ALWAYS_INLINE RowSampler(const GreyImage& image, float x, float y) : stride_(image.stride()) {
    const float floor_x = std::floor(x), floor_y = std::floor(y);
    const float fx = x - floor_x, fy = y - floor_y;
    w11_ = static_cast<std::uint16_t>(fx * fy * 128.0F + 0.5F);
    w01_ = static_cast<std::uint16_t>(static_cast<int>(fx * 128.0F + 0.5F) - w11_);
    w10_ = static_cast<std::uint16_t>(static_cast<int>(fy * 128.0F + 0.5F) - w11_);
    w00_ = static_cast<std::uint16_t>(128 - w01_ - w10_ - w11_);
    p_ = image.row(static_cast<int>(floor_y)) + static_cast<int>(floor_x);
    for (std::size_t v = 0; v < kVectors; ++v) load_words(left_[v], p_ + v * kLanes);
    for (std::size_t v = 0; v < kVectors; ++v) load_words(right_[v], p_ + v * kLanes + 1);
  }

  HINDSIGHT_ALWAYS_INLINE void next(Pixels (&row)[kVectors]) {
    p_ += stride_;
    for (std::size_t v = 0; v < kVectors; ++v) {
      Words left_below, right_below;
      load_words(left_below, p_ + v * kLanes), load_words(right_below, p_ + v * kLanes + 1);
      const Words sum = left_[v] * w00_ + right_[v] * w01_ + left_below * w10_ + right_below * w11_;
      row[v] = Pixels((sum + std::uint16_t{4}) >> std::uint16_t{3});
      left_[v] = left_below;
      right_[v] = right_below;
    }
  }

 private:
  std::ptrdiff_t stride_;
  const std::uint8_t* p_;
  std::uint16_t w00_, w01_, w10_, w11_;
  Words left_[kVectors], right_[kVectors];
};

/// What a level needs to know of the window in the image `from`.
template <std::size_t kWindow>
struct Template {
  static constexpr std::size_t kVectors = vectors_for(kWindow);
  Pixels grey[kWindow][kVectors];
  Pixels gx[kWindow][kVectors], gy[kWindow][kVectors];  ///< Sobel gradients, zero outside the window
  float inverse_xx, inverse_xy, inverse_yy;             ///< of the gradient matrix
};

/// The window's first pixel is at (x, y).
template <std::size_t kWindow>
HINDSIGHT_ALWAYS_INLINE void compute_gradients(const GreyImage& image, float x, float y,
                                               Template<kWindow>& t) {
  constexpr std::size_t kVectors = Template<kWindow>::kVectors;
  struct Row {  // beginning left of the window, with it, and right of its first pixel
    Pixels left[kVectors], middle[kVectors], right[kVectors];
  };
  RowSampler<kVectors> left(image, x - 1.0F, y - 1.0F), right(image, x + 1.0F, y - 1.0F);
  Row above, here, below;
  for (std::size_t r = 0; r < kWindow + 2; ++r) {
    above = here, here = below;
    left.next(below.left), right.next(below.right);
    for (std::size_t v = 0; v < kVectors; ++v) {
      below.middle[v] =
          __builtin_shuffle(below.left[v], below.right[v], Pixels{1, 2, 3, 4, 5, 6, 7, kLanes + 6});
      if (r < 2) continue;
      const Row &a = above, &b = here, &c = below;
      const Pixels gx = (a.right[v] - a.left[v]) + 2 * (b.right[v] - b.left[v]) + (c.right[v] - c.left[v]);
      const Pixels gy = (c.left[v] - a.left[v]) + 2 * (c.middle[v] - a.middle[v]) + (c.right[v] - a.right[v]);
      Pixels inside;
      mark_inside(kWindow, v, inside);
      t.grey[r - 2][v] = b.middle[v];
      t.gx[r - 2][v] = (gx >> 3) & inside;
      t.gy[r - 2][v] = (gy >> 3) & inside;
    }
  }
}

/// With gradients that sum to zero, a brightness that the whole window gained drops out of every product with
/// them.
template <std::size_t kWindow, std::size_t kVectors>
HINDSIGHT_ALWAYS_INLINE void remove_mean(Pixels (&gradient)[kWindow][kVectors]) {
  Sums sums{};
  for (const auto& row : gradient)
    for (const Pixels& g : row) add_products(sums, g, Pixels{} + std::int16_t{1});
  const auto mean = static_cast<std::int16_t>(
      std::lround(static_cast<float>(total(sums)) / static_cast<float>(kWindow * kWindow)));
  for (auto& row : gradient) {
    for (std::size_t v = 0; v < kVectors; ++v) {
      Pixels inside;
      mark_inside(kWindow, v, inside);
      row[v] -= inside & mean;
    }
  }
}

/// False if the window is too smooth in some direction.
template <std::size_t kWindow>
HINDSIGHT_ALWAYS_INLINE bool invert_gradient_matrix(float min_gradient, Template<kWindow>& t) {
  Sums sum_xx{}, sum_xy{}, sum_yy{};
  for (std::size_t r = 0; r < kWindow; ++r) {
    for (std::size_t v = 0; v < Template<kWindow>::kVectors; ++v) {
      add_products(sum_xx, t.gx[r][v], t.gx[r][v]);
      add_products(sum_xy, t.gx[r][v], t.gy[r][v]);
      add_products(sum_yy, t.gy[r][v], t.gy[r][v]);
    }
  }
  const float xx = static_cast<float>(total(sum_xx)), xy = static_cast<float>(total(sum_xy)),
              yy = static_cast<float>(total(sum_yy));
  const float smaller_eigenvalue = 0.5F * ((xx + yy) - std::sqrt((xx - yy) * (xx - yy) + 4.0F * xy * xy));
  constexpr float kPixels = kWindow * kWindow;
  const float determinant = xx * yy - xy * xy;
  if (!(smaller_eigenvalue > min_gradient * min_gradient * kProductUnit * kPixels) || !(determinant > 0.0F)) {
    return false;
  }
  t.inverse_xx = yy / determinant;
  t.inverse_xy = -xy / determinant;
  t.inverse_yy = xx / determinant;
  return true;
}

/// The step towards the match from a guess of where the window's first pixel is.
template <std::size_t kWindow>
HINDSIGHT_ALWAYS_INLINE Point2f solve_step(const Template<kWindow>& t, const GreyImage& image, float x,
                                           float y) {
  constexpr std::size_t kVectors = Template<kWindow>::kVectors;
  RowSampler<kVectors> found(image, x, y);
  Sums bx{}, by{};
  for (std::size_t r = 0; r < kWindow; ++r) {
    Pixels row[kVectors];
    found.next(row);
    for (std::size_t v = 0; v < kVectors; ++v) {
      const Pixels difference = t.grey[r][v] - row[v];
      add_products(bx, t.gx[r][v], difference);
      add_products(by, t.gy[r][v], difference);
    }
  }
  const Point2f b = totals(bx, by);
  return {t.inverse_xx * b.x_px + t.inverse_xy * b.y_px, t.inverse_xy * b.x_px + t.inverse_yy * b.y_px};
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
template <std::size_t kWindow>
HINDSIGHT_ALWAYS_INLINE OnLevel track_on_level(const TrackerParams& params, const GreyImage& from,
                                               const GreyImage& to, Point2f point, Point2f& guess) {
  constexpr float kReach = kWindow / 2;
  const auto stop = static_cast<float>(params.stop_step_px * params.stop_step_px);
  Template<kWindow> t;
  compute_gradients(from, point.x_px - kReach, point.y_px - kReach, t);
  if (params.remove_mean) {
    remove_mean(t.gx);
    remove_mean(t.gy);
  }
  if (!invert_gradient_matrix(static_cast<float>(params.min_gradient), t)) return OnLevel::too_smooth;
  const Bounds bounds = bounds_around(guess, static_cast<float>(params.max_move_px), bounds_of(to, kReach));
  for (int i = 0; i < params.max_iterations; ++i) {
    if (!bounds.contains(guess)) return OnLevel::lost;
    const Point2f step = solve_step(t, to, guess.x_px - kReach, guess.y_px - kReach);
    guess = {guess.x_px + step.x_px, guess.y_px + step.y_px};
    if (step.x_px * step.x_px + step.y_px * step.y_px < stop) break;
  }
  return bounds.contains(guess) ? OnLevel::matched : OnLevel::lost;
}

template <std::size_t kWindow>
HINDSIGHT_ALWAYS_INLINE TrackedPoint track_point(const TrackerParams& params, const ImagePyramid& from,
                                                 const ImagePyramid& to, int levels, Point2f point,
                                                 Point2f guess) {
  float scale = 1.0F / static_cast<float>(1 << (levels - 1));
  Point2f match{guess.x_px * scale, guess.y_px * scale};
  for (int level = levels - 1; level >= 0; --level, scale *= 2.0F) {
    const Point2f here{point.x_px * scale, point.y_px * scale};
    const OnLevel outcome = track_on_level<kWindow>(params, from.level(level), to.level(level), here, match);
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
  // A window's side known to the compiler keeps its rows in registers.
  const auto track = [&]<std::size_t kWindow>() __attribute__((always_inline)) {
    for (std::size_t i = 0; i < points_px.size(); ++i)
      tracked[i] = track_point<kWindow>(params, from, to, levels, points_px[i], guesses_px[i]);
  };
  switch (params.window_px) {
    case 3:
      return track.template operator()<3>();
    case 5:
      return track.template operator()<5>();
    case 7:
      return track.template operator()<7>();
    case 9:
      return track.template operator()<9>();
    case 11:
      return track.template operator()<11>();
    default:
      return track.template operator()<13>();
  }
}

}  // namespace hindsight
