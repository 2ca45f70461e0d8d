// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/jpeg_header.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "sim_replay/big_endian.h"

namespace hindsight {
namespace {

constexpr std::uint8_t kBaseline = 0xC0;
constexpr std::uint8_t kStartOfScan = 0xDA;

bool is_start_of_frame(std::uint8_t marker) {
  return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

/// A start-of-frame segment from its length on: length, precision, height, width, number of components.
JpegHeader read_frame_segment(std::span<const std::uint8_t> segment, std::uint8_t marker) {
  return {read_big_endian<std::uint16_t>(segment.data() + 5),
          read_big_endian<std::uint16_t>(segment.data() + 3),
          marker == kBaseline && segment[2] == 8 && segment[7] == 3};
}

bool has_end_of_image(std::span<const std::uint8_t> scan) {
  constexpr std::array<std::uint8_t, 2> end_of_image{0xFF, 0xD9};
  return std::search(scan.begin(), scan.end(), end_of_image.begin(), end_of_image.end()) != scan.end();
}

}  // namespace

std::optional<JpegHeader> read_jpeg_header(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < 4 || bytes[0] != 0xFF || bytes[1] != 0xD8) return std::nullopt;
  std::optional<JpegHeader> header;
  std::size_t at = 2;
  while (at + 4 <= bytes.size() && bytes[at] == 0xFF) {
    const std::uint8_t marker = bytes[at + 1];
    if (marker == 0xFF) {  // fill byte
      ++at;
      continue;
    }
    const auto segment = bytes.subspan(at + 2);
    const std::size_t length = read_big_endian<std::uint16_t>(segment.data());
    if (length < 2 || length > segment.size()) return std::nullopt;
    if (is_start_of_frame(marker) && length >= 8) header = read_frame_segment(segment, marker);
    if (marker == kStartOfScan) return has_end_of_image(segment) ? header : std::nullopt;
    at += 2 + length;
  }
  return std::nullopt;
}

}  // namespace hindsight
