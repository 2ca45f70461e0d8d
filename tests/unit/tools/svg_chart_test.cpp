// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/svg_chart.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace hindsight::tools {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(AxisMarks, AreRoundAndInside) {
  EXPECT_THAT(axis_marks(0.0, 10.0, 5), ElementsAre(0.0, 2.0, 4.0, 6.0, 8.0, 10.0));
  EXPECT_THAT(axis_marks(-0.3, 0.7, 4), ElementsAre(DoubleEq(0.0), DoubleEq(0.5)));
}

TEST(AxisMarks, OfAnEmptyRangeAreNone) { EXPECT_TRUE(axis_marks(1.0, 1.0, 5).empty()); }

TEST(SvgChart, BreaksLinesAtNan) {
  SvgChart chart(400, 200, {0.0, 4.0, "x"}, {0.0, 1.0, "y"});
  const std::vector<double> x{0, 1, 2, 3, 4};
  const std::vector<double> y{0, 1, std::numeric_limits<double>::quiet_NaN(), 1, 0};
  chart.line(x, y, kLeft, "speed");
  EXPECT_EQ(count(chart.text(), "<polyline"), 2U);
}

TEST(SvgChart, KeepsTheExtremesOfLongLines) {
  SvgChart chart(400, 200, {0.0, 1e5, "x"}, {0.0, 1.0, "y"});
  std::vector<double> x, y;
  for (int i = 0; i < 100000; ++i) x.push_back(i), y.push_back(i == 54321 ? 1.0 : 0.0);
  chart.line(x, y, kLeft, "speed");
  EXPECT_LT(chart.text().size(), 20000U);
  EXPECT_THAT(chart.text(), HasSubstr(",30.0 "));  // the top of the plot
}

TEST(SvgChart, EscapesLabels) {
  SvgChart chart(400, 200, {0.0, 1.0, "<x>"}, {0.0, 1.0, "y"});
  chart.legend("a & b", kLeft);
  EXPECT_THAT(chart.text(), HasSubstr("&lt;x&gt;"));
  EXPECT_THAT(chart.text(), HasSubstr("a &amp; b"));
  EXPECT_THAT(chart.text(), Not(HasSubstr("<x>")));
}

}  // namespace
}  // namespace hindsight::tools
