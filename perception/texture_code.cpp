// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/texture_code.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

#include "perception/multiversion.h"

namespace hindsight {
namespace {

constexpr int kRadius = 2;
/// Sum of the 20 differences at which level k + 1 begins: 20 * 2 (2^((k + 1) / 2) - 1).
constexpr std::uint16_t kLevelBegins[kTextureLevels - 1] = {17, 40, 74, 120, 187, 280, 413};

std::uint8_t grey_of(const std::uint8_t* bgr) {
  return static_cast<std::uint8_t>((bgr[0] + 2 * bgr[1] + bgr[2] + 2) >> 2);
}

HINDSIGHT_ALWAYS_INLINE std::uint8_t level(std::uint16_t sum) {
  std::uint8_t level = 0;
  for (const std::uint16_t begins : kLevelBegins) level = static_cast<std::uint8_t>(level + (sum >= begins));
  return level;
}

HINDSIGHT_MULTIVERSION
void grey_row(const std::uint8_t* bgr, std::size_t width, std::uint8_t* __restrict grey) {
  for (std::size_t x = 0; x < width; ++x)
    grey[x] = static_cast<std::uint8_t>((bgr[3 * x] + 2 * bgr[3 * x + 1] + bgr[3 * x + 2] + 2) >> 2);
}

/// sum[x] += |a[x] - b[x]|
HINDSIGHT_MULTIVERSION
void add_differences(const std::uint8_t* a, const std::uint8_t* b, std::size_t count,
                     std::uint16_t* __restrict sum) {
  for (std::size_t x = 0; x < count; ++x) {
    const std::uint8_t difference = static_cast<std::uint8_t>(a[x] > b[x] ? a[x] - b[x] : b[x] - a[x]);
    sum[x] = static_cast<std::uint16_t>(sum[x] + difference);
  }
}

/// across[x] to across[x + 3] are the differences across around column x, down[x] to down[x + 4] those down.
HINDSIGHT_MULTIVERSION
void code_columns(const std::uint16_t* across, const std::uint16_t* down, std::size_t width,
                  std::uint8_t* __restrict codes) {
  for (std::size_t x = 0; x < width; ++x) {
    const auto a = static_cast<std::uint16_t>(across[x] + across[x + 1] + across[x + 2] + across[x + 3]);
    const auto d =
        static_cast<std::uint16_t>(down[x] + down[x + 1] + down[x + 2] + down[x + 3] + down[x + 4]);
    codes[x] = static_cast<std::uint8_t>(kTextureLevels * level(a) + level(d));
  }
}

}  // namespace

std::uint8_t texture_code_at(std::span<const std::uint8_t> bgr, int width_px, int height_px, int x, int y) {
  const auto grey = [&](int dx, int dy) {
    const int column = std::clamp(x + dx, 0, width_px - 1), row = std::clamp(y + dy, 0, height_px - 1);
    return static_cast<int>(grey_of(&bgr[3 * static_cast<std::size_t>(row * width_px + column)]));
  };
  int across = 0, down = 0;
  for (int i = -kRadius; i <= kRadius; ++i) {
    for (int j = -kRadius; j < kRadius; ++j) {
      across += std::abs(grey(j + 1, i) - grey(j, i));
      down += std::abs(grey(i, j + 1) - grey(i, j));
    }
  }
  return static_cast<std::uint8_t>(kTextureLevels * level(static_cast<std::uint16_t>(across)) +
                                   level(static_cast<std::uint16_t>(down)));
}

TextureMap::TextureMap(int width_px, int height_px)
    : width_px_(width_px),
      height_px_(height_px),
      stride_(static_cast<std::size_t>(width_px + 2 * kRadius)),
      grey_(stride_ * static_cast<std::size_t>(height_px + 2 * kRadius)),
      across_(stride_),
      down_(stride_),
      codes_(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px)) {}

std::span<const std::uint8_t> TextureMap::update(std::span<const std::uint8_t> bgr) {
  find_greys(bgr);
  for (int y = 0; y < height_px_; ++y) {
    find_differences(y);
    code_row(y);
  }
  return codes_;
}

void TextureMap::find_greys(std::span<const std::uint8_t> bgr) {
  const auto width = static_cast<std::size_t>(width_px_);
  for (int y = 0; y < height_px_; ++y) {
    std::uint8_t* const row = &grey_[static_cast<std::size_t>(y + kRadius) * stride_];
    grey_row(&bgr[3 * static_cast<std::size_t>(y) * width], width, row + kRadius);
    std::fill_n(row, kRadius, row[kRadius]);
    std::fill_n(row + kRadius + width, kRadius, row[kRadius + width - 1]);
  }
  for (std::size_t margin = 0; margin < kRadius; ++margin) {
    const auto last = static_cast<std::size_t>(height_px_ + kRadius - 1);
    std::copy_n(&grey_[kRadius * stride_], stride_, &grey_[margin * stride_]);
    std::copy_n(&grey_[last * stride_], stride_, &grey_[(last + 1 + margin) * stride_]);
  }
}

void TextureMap::find_differences(int y) {
  std::ranges::fill(across_, std::uint16_t{0});
  std::ranges::fill(down_, std::uint16_t{0});
  const std::uint8_t* row = &grey_[static_cast<std::size_t>(y) * stride_];
  for (int i = 0; i <= 2 * kRadius; ++i, row += stride_) {
    add_differences(row, row + 1, stride_ - 1, across_.data());
    if (i < 2 * kRadius) add_differences(row, row + stride_, stride_, down_.data());
  }
}

void TextureMap::code_row(int y) {
  const auto width = static_cast<std::size_t>(width_px_);
  code_columns(across_.data(), down_.data(), width, &codes_[static_cast<std::size_t>(y) * width]);
}

}  // namespace hindsight
