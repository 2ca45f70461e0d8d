// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/activity_codec.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "config/crc32.h"
#include "perception/saved_bytes.h"

namespace hindsight {
namespace {

constexpr std::array<std::uint8_t, 4> kMagic{'H', 'S', 'A', 'M'};
constexpr std::uint16_t kVersion = 2, kWithoutExposure = 1;
constexpr std::size_t kHeaderBytes = 32, kChecksumBytes = 4;

ActivityDecoded refused(const std::string& problem) { return {{}, problem}; }

/// Runs of cells with one exposure, row by row: how many, and the exposure.
void put_exposures(std::vector<std::uint8_t>& out, std::span<const std::uint32_t> exposures) {
  for (auto at = exposures.begin(); at != exposures.end();) {
    const auto end = std::find_if(at, exposures.end(), [&](std::uint32_t other) { return other != *at; });
    put(out, static_cast<std::uint32_t>(end - at));
    put(out, *at);
    at = end;
  }
}

bool take_exposures(ByteReader& in, std::span<std::uint32_t> exposures) {
  while (!exposures.empty()) {
    const auto cells = in.take<std::uint32_t>(), frames = in.take<std::uint32_t>();
    if (!in.ok() || cells == 0 || cells > exposures.size()) return false;
    std::fill_n(exposures.begin(), cells, frames);
    exposures = exposures.subspan(cells);
  }
  return true;
}

}  // namespace

std::vector<std::uint8_t> encode_activity(const ActivityMap& map) {
  std::vector<std::uint8_t> out(kMagic.begin(), kMagic.end());
  put(out, kVersion);
  put(out, std::uint16_t{0});
  put(out, map.cell());
  put(out, static_cast<std::uint32_t>(map.cells()));
  put(out, map.params().max_speed);
  put(out, static_cast<std::uint32_t>(map.active().size()));
  for (std::size_t i = 0; i < map.active().size(); ++i) {
    const auto counts = map.counts(i);
    put(out, static_cast<std::uint32_t>(map.active()[i].column));
    put(out, static_cast<std::uint32_t>(map.active()[i].row));
    put(out, static_cast<std::uint32_t>(
                 counts.size() - static_cast<std::size_t>(std::count(counts.begin(), counts.end(), 0U))));
    for (std::size_t bin = 0; bin < counts.size(); ++bin) {
      if (counts[bin] == 0) continue;
      put(out, static_cast<std::uint16_t>(bin));
      put(out, counts[bin]);
    }
  }
  put_exposures(out, map.exposures());
  put(out, crc32(out));
  return out;
}

ActivityDecoded decode_activity(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kHeaderBytes + kChecksumBytes)
    return refused(fmt::format("ends at byte {}, within the header", bytes.size()));
  if (!std::equal(kMagic.begin(), kMagic.end(), bytes.begin()))
    return refused("byte 0: is no activity map (expected \"HSAM\")");
  const auto body = bytes.first(bytes.size() - kChecksumBytes);
  ByteReader in(body.subspan(kMagic.size()));
  const auto version = in.take<std::uint16_t>();
  if (version != kVersion && version != kWithoutExposure) {
    return refused(fmt::format("byte 4: version {}, expected {} or {}", version, kWithoutExposure, kVersion));
  }
  if (crc32(body) != ByteReader(bytes.last(kChecksumBytes)).take<std::uint32_t>()) {
    return refused(fmt::format("byte {}: the checksum does not fit", body.size()));
  }
  in.take<std::uint16_t>();
  ActivityMapParams params;
  params.cell = in.take_double();
  const auto cells = in.take<std::uint32_t>();
  params.max_speed = in.take_double();
  if (!(params.cell > 0.0 && params.cell < 1e6) || cells < 8 || cells > 1024 ||
      !(params.max_speed > 0.0 && params.max_speed < 1e6)) {
    return refused("byte 8: no map has such cells, so many or such speeds");
  }
  params.cells = static_cast<int>(cells);
  ActivityMap map(params);
  const auto count = in.take<std::uint32_t>();
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::size_t begin = in.at() + kMagic.size();
    const auto column = in.take<std::uint32_t>(), row = in.take<std::uint32_t>(),
               bins = in.take<std::uint32_t>();
    for (std::uint32_t k = 0; k < bins && in.ok(); ++k) {
      const auto bin = in.take<std::uint16_t>();
      const auto times = in.take<std::uint32_t>();
      if (in.ok() && column < cells && row < cells &&
          map.add_count(static_cast<int>(column), static_cast<int>(row), bin, times)) {
        continue;
      }
      return refused(fmt::format("byte {}: cell {} is none of the map's", begin, i));
    }
    if (!in.ok()) return refused(fmt::format("byte {}: ends within cell {}", begin, i));
  }
  if (const std::size_t begin = in.at() + kMagic.size();
      version == kVersion && !take_exposures(in, map.exposures())) {
    return refused(fmt::format("byte {}: expected the exposure of {} x {} cells", begin, cells, cells));
  }
  if (in.at() + kMagic.size() != body.size())
    return refused(fmt::format("byte {}: expected the checksum", in.at() + kMagic.size()));
  return {std::move(map), {}};
}

}  // namespace hindsight
