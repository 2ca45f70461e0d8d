// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/movingai.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include "config/exit_code.h"

namespace hindsight::tools {

namespace {

constexpr int kMaxSide = 16384;

// A text file read line by line, which knows where it is.
class Lines {
 public:
  explicit Lines(const std::filesystem::path& path) : path_(path), file_(path) {
    if (!file_) throw FatalError(kExitNoInput, fmt::format("{}: cannot be read", path.string()));
  }
  bool next(std::string& line) {
    ++number_;
    if (!std::getline(file_, line)) return false;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    return true;
  }
  [[noreturn]] void fail(const std::string& expected) const {
    throw FatalError(kExitBadData, fmt::format("{}:{}: expected {}", path_.string(), number_, expected));
  }

 private:
  std::filesystem::path path_;
  std::ifstream file_;
  int number_ = 0;
};

int read_side(Lines& lines, const std::string& name) {
  std::string line, word, rest;
  int value = 0;
  const bool there = lines.next(line);
  std::istringstream in(line);
  if (!there || !(in >> word >> value) || word != name || (in >> rest) || value < 1 || value > kMaxSide)
    lines.fail(fmt::format("'{} N' with N from 1 to {}", name, kMaxSide));
  return value;
}

bool passable(char c) { return c == '.' || c == 'G' || c == 'S'; }

}  // namespace

MovingAiMap read_movingai_map(const std::filesystem::path& path) {
  Lines lines(path);
  std::string line;
  if (!lines.next(line) || line != "type octile") lines.fail("'type octile'");
  MovingAiMap map;
  map.height = read_side(lines, "height");
  map.width = read_side(lines, "width");
  if (!lines.next(line) || line != "map") lines.fail("'map'");
  map.costs.reserve(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height));
  for (int y = 0; y < map.height; ++y) {
    if (!lines.next(line) || line.size() != static_cast<std::size_t>(map.width))
      lines.fail(fmt::format("a row of {} cells", map.width));
    for (const char c : line) {
      if (std::string_view(".GS@OTW").find(c) == std::string_view::npos)
        lines.fail("only cells out of '.GS@OTW'");
      map.costs.push_back(passable(c) ? kFreeCost : kLethalCost);
    }
  }
  return map;
}

std::vector<MovingAiProblem> read_movingai_scenario(const std::filesystem::path& path,
                                                    const MovingAiMap& map) {
  Lines lines(path);
  std::string line;
  if (!lines.next(line) || line.rfind("version 1", 0) != 0) lines.fail("'version 1'");
  std::vector<MovingAiProblem> problems;
  while (lines.next(line)) {
    if (line.empty()) continue;
    std::istringstream in(line);
    std::string name;
    int bucket = 0, width = 0, height = 0, start_x = 0, start_y = 0, goal_x = 0, goal_y = 0;
    double length = 0.0;
    if (!(in >> bucket >> name >> width >> height >> start_x >> start_y >> goal_x >> goal_y >> length))
      lines.fail("bucket, map, width, height, start x, y, goal x, y, optimal length");
    if (width != map.width || height != map.height)
      lines.fail(fmt::format("the map's size, {} x {}", map.width, map.height));
    const auto inside = [&](int x, int y) { return x >= 0 && y >= 0 && x < map.width && y < map.height; };
    if (!inside(start_x, start_y) || !inside(goal_x, goal_y)) lines.fail("start and goal inside the map");
    const int start = start_y * map.width + start_x, goal = goal_y * map.width + goal_x;
    problems.push_back({start, goal, length, length == 0.0 && start != goal});
  }
  return problems;
}

}  // namespace hindsight::tools
