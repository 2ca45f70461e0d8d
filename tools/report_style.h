// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Colours and names that all parts of a report share.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>

#include "drivers/samples.h"
#include "perception/terrain_class.h"
#include "perception/training_events.h"
#include "planning/behaviours.h"

namespace hindsight::tools {

struct Rgb {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;

  cv::Scalar bgr() const { return {static_cast<double>(b), static_cast<double>(g), static_cast<double>(r)}; }
  cv::Vec3b pixel() const { return {b, g, r}; }
  std::string hex() const;  ///< "#rrggbb"
  bool operator==(const Rgb&) const = default;
};

constexpr Rgb kInk{31, 41, 51};
constexpr Rgb kFaint{203, 210, 217};
constexpr Rgb kPaper{255, 255, 255};
constexpr Rgb kUnknown{235, 238, 241};
constexpr Rgb kGood{46, 158, 91};
constexpr Rgb kBad{242, 142, 43};
constexpr Rgb kLethal{214, 47, 58};
constexpr Rgb kLeft{47, 111, 178};
constexpr Rgb kRight{123, 79, 181};
constexpr Rgb kStale{240, 200, 40};
constexpr Rgb kAccent{0, 188, 212};

Rgb color_of(TerrainClass label);
Rgb color_of(SourceState state);
Rgb color_of(TrainingCause cause);

const char* name_of(TerrainClass label);
const char* name_of(SourceState state);
const char* name_of(Source source);
const char* name_of(TrainingCause cause);
const char* name_of(Behaviour behaviour);

/// A touch, a near miss or slip; not ground that was merely driven over.
constexpr bool is_contact(TrainingCause cause) { return cause != TrainingCause::driven_over; }

}  // namespace hindsight::tools
