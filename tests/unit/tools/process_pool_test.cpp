// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/process_pool.h"

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>
#include <string>

namespace hindsight::tools {
namespace {

TEST(ProcessPool, GivesBackWhatEachPieceMade) {
  std::map<int, std::string> results;
  // Longer than a pipe holds.
  const auto work = [](int i) { return std::string(200'000, static_cast<char>('a' + i)); };
  EXPECT_EQ(run_in_processes(5, 2, work, [&](int i, const std::string& text) { results[i] = text; }), 0);
  ASSERT_EQ(results.size(), 5U);
  for (const auto& [i, text] : results) EXPECT_EQ(text, work(i)) << i;
}

TEST(ProcessPool, CountsThePiecesThatFail) {
  int done = 0;
  const auto work = [](int i) -> std::string {
    return i == 1 ? throw std::runtime_error("this one fails") : "good";
  };
  EXPECT_EQ(run_in_processes(3, 2, work, [&](int, const std::string&) { ++done; }), 1);
  EXPECT_EQ(done, 2);
}

}  // namespace
}  // namespace hindsight::tools
