// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/report_mixture.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "perception/color_space.h"

namespace hindsight::tools {
namespace {

TEST(ScreenColor, BringsLabBackToTheSameColour) {
  for (const Rgb color :
       {Rgb{0, 0, 0}, Rgb{255, 255, 255}, Rgb{200, 30, 60}, Rgb{10, 120, 240}, Rgb{90, 140, 20}}) {
    const Rgb back =
        screen_color(ColorSpace::lab, hindsight::color_of(ColorSpace::lab, color.b, color.g, color.r));
    EXPECT_LE(std::abs(back.r - color.r), 1) << color.hex() << " came back as " << back.hex();
    EXPECT_LE(std::abs(back.g - color.g), 1) << color.hex() << " came back as " << back.hex();
    EXPECT_LE(std::abs(back.b - color.b), 1) << color.hex() << " came back as " << back.hex();
  }
}

TEST(ScreenColor, TakesRgbMeansAsTheyAre) {
  EXPECT_EQ(screen_color(ColorSpace::rgb, {12.4, 100.0, 300.0}), (Rgb{12, 100, 255}));
}

}  // namespace
}  // namespace hindsight::tools
