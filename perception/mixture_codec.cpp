// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/mixture_codec.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <array>
#include <cmath>

#include "config/crc32.h"
#include "perception/saved_bytes.h"

namespace hindsight {
namespace {

constexpr std::array<std::uint8_t, 4> kMagic{'H', 'S', 'M', 'X'};
constexpr std::uint16_t kVersion = 2, kVersionWithoutTexture = 1;
constexpr std::size_t kHeaderBytes = 12, kComponentBytes = 13 * 8 + 1, kChecksumBytes = 4;
constexpr std::size_t kTextureBytes = sizeof(TextureVotes);

MixtureComponent take_component(ByteReader& in) {
  MixtureComponent c;
  for (double& m : c.mean) m = in.take_double();
  for (int row = 0; row < 3; ++row) {
    for (int column = row; column < 3; ++column)
      c.covariance(row, column) = c.covariance(column, row) = in.take_double();
  }
  c.weight_px = in.take_double();
  for (double& v : c.votes) v = in.take_double();
  c.label = static_cast<TerrainClass>(in.take<std::uint8_t>());
  return c;
}

bool sound(const MixtureComponent& c) {
  if (!c.mean.allFinite() || !c.covariance.allFinite() || c.label > TerrainClass::unknown) return false;
  if (!std::isfinite(c.weight_px) || c.weight_px < 0.0) return false;
  for (const double v : c.votes) {
    if (!std::isfinite(v) || v < 0.0) return false;
  }
  return c.covariance.llt().info() == Eigen::Success;
}

/// What is wrong with header, length or checksum; empty if nothing.
std::string envelope_problem(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kHeaderBytes + kChecksumBytes) {
    return fmt::format("ends at byte {}, within the header", bytes.size());
  }
  ByteReader in(bytes);
  for (const std::uint8_t magic : kMagic) {
    if (in.take<std::uint8_t>() != magic) return "byte 0: is no mixture (expected \"HSMX\")";
  }
  const auto version = in.take<std::uint16_t>();
  if (version != kVersion && version != kVersionWithoutTexture)
    return fmt::format("byte 4: version {}, expected {}", version, kVersion);
  if (const auto space = in.take<std::uint8_t>(); space > 1)
    return fmt::format("byte 6: colour space {}", space);
  if (in.take<std::uint8_t>() != 0) return "byte 7: expected 0";
  const auto count = in.take<std::uint32_t>();
  if (count > kMostComponents)
    return fmt::format("byte 8: {} components, at most {}", count, kMostComponents);
  const std::size_t expected =
      kHeaderBytes + count * kComponentBytes + (version == kVersion ? kTextureBytes : 0) + kChecksumBytes;
  if (bytes.size() != expected)
    return fmt::format("is {} bytes long, {} components take {}", bytes.size(), count, expected);
  const auto body = bytes.first(expected - kChecksumBytes);
  if (crc32(body) != ByteReader(bytes.last(kChecksumBytes)).take<std::uint32_t>()) {
    return fmt::format("byte {}: the checksum does not fit", body.size());
  }
  return {};
}

}  // namespace

std::vector<std::uint8_t> encode_mixture(const MixtureSnapshot& mixture) {
  std::vector<std::uint8_t> out;
  out.reserve(kHeaderBytes + mixture.components.size() * kComponentBytes + kTextureBytes + kChecksumBytes);
  for (const std::uint8_t magic : kMagic) put(out, magic);
  put(out, kVersion);
  put(out, static_cast<std::uint8_t>(mixture.color_space));
  put(out, std::uint8_t{0});
  put(out, static_cast<std::uint32_t>(mixture.components.size()));
  for (const MixtureComponent& c : mixture.components) {
    for (const double m : c.mean) put(out, m);
    for (int row = 0; row < 3; ++row) {
      for (int column = row; column < 3; ++column) put(out, c.covariance(row, column));
    }
    put(out, c.weight_px);
    for (const double v : c.votes) put(out, v);
    put(out, static_cast<std::uint8_t>(c.label));
  }
  for (const auto& votes : mixture.texture) {
    for (const double v : votes) put(out, v);
  }
  put(out, crc32(out));
  return out;
}

MixtureDecoded decode_mixture(std::span<const std::uint8_t> bytes) {
  MixtureDecoded result;
  result.problem = envelope_problem(bytes);
  if (!result.problem.empty()) return result;
  const bool has_texture = ByteReader(bytes.subspan(4)).take<std::uint16_t>() == kVersion;
  ByteReader in(bytes.subspan(6));
  result.mixture.color_space = static_cast<ColorSpace>(in.take<std::uint16_t>());
  const auto count = in.take<std::uint32_t>();
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::size_t begin = in.at() + 6;
    result.mixture.components.push_back(take_component(in));
    if (sound(result.mixture.components.back())) continue;
    return {{}, fmt::format("byte {}: component {} is no Gaussian with votes", begin, i)};
  }
  if (!has_texture) return result;
  for (auto& votes : result.mixture.texture) {
    for (double& v : votes) {
      const std::size_t begin = in.at() + 6;
      v = in.take_double();
      if (!std::isfinite(v) || v < 0.0) return {{}, fmt::format("byte {}: no number of votes", begin)};
    }
  }
  return result;
}

}  // namespace hindsight
