// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "config/nearest_name.h"

#include <gtest/gtest.h>

namespace hindsight {
namespace {

TEST(NearestName, CountsInsertionsDeletionsAndReplacements) {
  const std::set<std::string> known = {"gain", "threshold", "window_px", "window_s"};
  EXPECT_EQ(nearest_name("windw_px", known), "window_px");
  EXPECT_EQ(nearest_name("windows", known), "window_s");
  EXPECT_EQ(nearest_name("tresshold", known), "threshold");
  EXPECT_EQ(nearest_name("main", known), "gain");
  EXPECT_EQ(nearest_name("", known), "gain");
}

}  // namespace
}  // namespace hindsight
