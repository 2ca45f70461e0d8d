// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/saved_state.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "config/crc32.h"
#include "perception/saved_bytes.h"

namespace hindsight {
namespace {

constexpr std::array<std::uint8_t, 4> kMagic{'H', 'S', 'S', 'T'};
constexpr std::uint16_t kVersion = 1;
constexpr std::size_t kHeaderBytes = 28, kPoseBytes = 24, kChecksumBytes = 4;
constexpr double kMostBias_radps = 1.0;

bool is_finite(const Pose2& X) {
  return std::isfinite(X.x_m) && std::isfinite(X.y_m) && std::isfinite(X.heading_rad);
}

/// What is wrong before any number is believed; empty if nothing.
std::string envelope_problem(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kHeaderBytes + kChecksumBytes) return "it ends within the header";
  if (!std::equal(kMagic.begin(), kMagic.end(), bytes.begin()))
    return "it is no saved state (expected \"HSST\")";
  const auto body = bytes.first(bytes.size() - kChecksumBytes);
  if (crc32(body) != ByteReader(bytes.last(kChecksumBytes)).take<std::uint32_t>())
    return "the checksum does not fit";
  ByteReader in(bytes.subspan(kMagic.size()));
  if (in.take<std::uint16_t>() != kVersion || in.take<std::uint16_t>() != 0)
    return "it is of another version";
  if ((body.size() - kHeaderBytes) % kPoseBytes != 0) return "it ends within a pose";
  ByteReader count(bytes.subspan(kHeaderBytes - sizeof(std::uint32_t)));
  if (count.take<std::uint32_t>() != (body.size() - kHeaderBytes) / kPoseBytes)
    return "its number of poses does not fit";
  return {};
}

}  // namespace

std::vector<std::uint8_t> encode_state(const SavedState& state) {
  std::vector<std::uint8_t> out(kMagic.begin(), kMagic.end());
  put(out, kVersion);
  put(out, std::uint16_t{0});
  put(out, static_cast<std::uint64_t>(state.utime_us));
  put(out, state.gyro_bias_radps);
  put(out, static_cast<std::uint32_t>(state.track.size()));
  for (const Pose2& X_WB : state.track) {
    for (const double number : {X_WB.x_m, X_WB.y_m, X_WB.heading_rad}) put(out, number);
  }
  put(out, crc32(out));
  return out;
}

StateDecoded decode_state(std::span<const std::uint8_t> bytes) {
  if (std::string problem = envelope_problem(bytes); !problem.empty()) return {{}, std::move(problem)};
  ByteReader in(bytes.subspan(kMagic.size() + 4));
  StateDecoded result;
  result.state.utime_us = static_cast<std::int64_t>(in.take<std::uint64_t>());
  result.state.gyro_bias_radps = in.take_double();
  if (!(std::abs(result.state.gyro_bias_radps) <= kMostBias_radps)) return {{}, "its gyro bias is none"};
  for (auto count = in.take<std::uint32_t>(); count > 0; --count) {
    Pose2 X_WB;
    for (double* number : {&X_WB.x_m, &X_WB.y_m, &X_WB.heading_rad}) *number = in.take_double();
    if (!is_finite(X_WB)) return {{}, "a pose is none"};
    result.state.track.push_back(X_WB);
  }
  return result;
}

}  // namespace hindsight
