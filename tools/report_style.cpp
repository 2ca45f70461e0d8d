// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/report_style.h"

#include <fmt/format.h>

#include <array>

namespace hindsight::tools {
namespace {

template <typename Enum, typename Value, std::size_t N>
Value look_up(Enum key, const std::array<Value, N>& values) {
  return values.at(static_cast<std::size_t>(key));
}

}  // namespace

std::string Rgb::hex() const { return fmt::format("#{:02x}{:02x}{:02x}", r, g, b); }

Rgb color_of(TerrainClass label) { return look_up(label, std::array{kGood, kBad, kLethal, kUnknown}); }

Rgb color_of(SourceState state) { return look_up(state, std::array{kFaint, kGood, kStale, kLethal, kPaper}); }

Rgb color_of(TrainingCause cause) {
  return look_up(cause, std::array{kLethal, kLethal, kBad, kBad, kRight, kGood, kLethal});
}

const char* name_of(TerrainClass label) {
  return look_up(label, std::array{"good", "bad", "lethal", "unknown"});
}

const char* name_of(SourceState state) {
  return look_up(state, std::array{"never seen", "fresh", "stale", "failed", "absent"});
}

const char* name_of(Source source) {
  return look_up(source, std::array{"camera", "CAN bus", "GPIO lines", "GPS", "operator link"});
}

const char* name_of(TrainingCause cause) {
  return look_up(cause, std::array{"bumper left", "bumper right", "IR left", "IR right", "slip",
                                   "driven over", "both bumpers"});
}

const char* name_of(Behaviour behaviour) {
  return look_up(behaviour, std::array{"idle", "halted", "follow", "stopping", "back up", "turn away",
                                       "arrived", "no path", "stuck"});
}

}  // namespace hindsight::tools
