// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/appearance_history.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "config/exit_code.h"

namespace hindsight {
namespace {

constexpr std::size_t kChannels = 3;

/// sums[i] = the sum of byte i over `rows` rows.
void sum_rows(const std::uint8_t* first_row, std::size_t row_bytes, int rows, std::uint16_t* sums) {
  for (std::size_t i = 0; i < row_bytes; ++i) sums[i] = first_row[i];
  for (int row = 1; row < rows; ++row) {
    const std::uint8_t* bytes = first_row + static_cast<std::size_t>(row) * row_bytes;
    for (std::size_t i = 0; i < row_bytes; ++i) sums[i] = static_cast<std::uint16_t>(sums[i] + bytes[i]);
  }
}

/// averages[i] = the rounded mean of `kShrink` pixels of the same channel from byte i on. It is computed for
/// every byte, not just for those that are kept, because so the compiler vectorises it.
template <int kShrink>
void average_pixels(const std::uint16_t* sums, std::size_t count, std::uint8_t* averages) {
  constexpr unsigned kArea = kShrink * kShrink;
  for (std::size_t i = 0; i < count; ++i) {
    unsigned sum = kArea / 2;
    for (std::size_t k = 0; k < kShrink; ++k) sum += sums[i + k * kChannels];
    averages[i] = static_cast<std::uint8_t>(static_cast<std::uint16_t>(sum) / kArea);
  }
}

void keep_every(int shrink, const std::uint8_t* averages, int pixels, std::uint8_t* out) {
  const std::size_t step = static_cast<std::size_t>(shrink) * kChannels;
  for (int x = 0; x < pixels; ++x, averages += step, out += kChannels) {
    out[0] = averages[0];
    out[1] = averages[1];
    out[2] = averages[2];
  }
}

}  // namespace

AppearanceHistory::AppearanceHistory(const AppearanceHistoryParams& params, int depth, int width_px,
                                     int height_px)
    : depth_(depth),
      shrink_(params.shrink),
      width_px_(width_px),
      height_px_(height_px),
      stored_width_px_(width_px / params.shrink),
      stored_height_px_(height_px / params.shrink),
      picture_bytes_(static_cast<std::size_t>(stored_width_px_) *
                     static_cast<std::size_t>(stored_height_px_) * kChannels) {
  if (shrink_ != 1 && shrink_ != 2 && shrink_ != 4)
    throw FatalError(kExitConfiguration,
                     fmt::format("appearance history: shrink is {}, expected 1, 2 or 4", shrink_));
  ring_.resize(static_cast<std::size_t>(depth) * picture_bytes_);
  const std::size_t row_bytes = static_cast<std::size_t>(width_px) * kChannels;
  row_sums_.resize(row_bytes);
  averages_.resize(row_bytes);
}

void AppearanceHistory::push(std::span<const std::uint8_t> bgr) {
  newest_ = (newest_ + 1) % depth_;
  size_ = std::min(size_ + 1, depth_);
  std::uint8_t* out = ring_.data() + slot_offset(0);
  if (shrink_ == 1) {
    std::memcpy(out, bgr.data(), picture_bytes_);
    return;
  }
  const std::size_t row_bytes = static_cast<std::size_t>(width_px_) * kChannels;
  const std::size_t averaged = row_bytes - static_cast<std::size_t>(shrink_ - 1) * kChannels;
  for (int row = 0; row < stored_height_px_;
       ++row, out += static_cast<std::size_t>(stored_width_px_) * kChannels) {
    sum_rows(bgr.data() + static_cast<std::size_t>(row * shrink_) * row_bytes, row_bytes, shrink_,
             row_sums_.data());
    shrink_ == 2 ? average_pixels<2>(row_sums_.data(), averaged, averages_.data())
                 : average_pixels<4>(row_sums_.data(), averaged, averages_.data());
    keep_every(shrink_, averages_.data(), stored_width_px_, out);
  }
}

std::size_t AppearanceHistory::slot_offset(int frames_back) const {
  const int slot = newest_ >= frames_back ? newest_ - frames_back : newest_ - frames_back + depth_;
  return static_cast<std::size_t>(slot) * picture_bytes_;
}

int AppearanceHistory::stored_index(ImagePoint full_px) const {
  // Pixel n covers [n - 0.5, n + 0.5).
  const double x = std::floor((full_px.x_px + 0.5) / shrink_), y = std::floor((full_px.y_px + 0.5) / shrink_);
  if (!(x >= 0 && y >= 0 && x < stored_width_px_ && y < stored_height_px_)) return -1;
  return static_cast<int>(y) * stored_width_px_ + static_cast<int>(x);
}

Bgr AppearanceHistory::stored(int frames_back, int index) const {
  const std::uint8_t* pixel =
      ring_.data() + slot_offset(frames_back) + static_cast<std::size_t>(index) * kChannels;
  return {pixel[0], pixel[1], pixel[2]};
}

std::span<const std::uint8_t> AppearanceHistory::picture(int frames_back) const {
  if (frames_back < 0 || frames_back >= size_) return {};
  return {ring_.data() + slot_offset(frames_back), picture_bytes_};
}

void AppearanceHistory::collect(int frames_back, const ImageRect& full_px, std::vector<Bgr>& pixels) const {
  if (frames_back < 0 || frames_back >= size_) return;
  const auto cell = [this](float px, int end) {
    return static_cast<int>(
        std::clamp(std::floor(px / static_cast<float>(shrink_)), 0.0F, static_cast<float>(end)));
  };
  const auto cell_after = [this](float px, int end) {
    return static_cast<int>(
        std::clamp(std::ceil(px / static_cast<float>(shrink_)), 0.0F, static_cast<float>(end)));
  };
  const int left = cell(full_px.x_px, stored_width_px_),
            right = cell_after(full_px.x_px + full_px.width_px, stored_width_px_);
  const int top = cell(full_px.y_px, stored_height_px_),
            bottom = cell_after(full_px.y_px + full_px.height_px, stored_height_px_);
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) pixels.push_back(stored(frames_back, y * stored_width_px_ + x));
  }
}

}  // namespace hindsight
