// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/world/course.h"

#include <fmt/format.h>

#include <algorithm>

#include "config/configuration.h"
#include "config/exit_code.h"

namespace hindsight {
namespace {

/// What no single range can say. Names the line of the first key of the section that the document has.
class Plausibility {
 public:
  explicit Plausibility(const ConfigDocument& document) : document_(document) {}

  void expect(bool good, const char* section, const char* key, const std::string& what) const {
    if (good) return;
    throw FatalError(kExitConfiguration, fmt::format("{}:{}: [{}] {}: {}", document_.file_name,
                                                     line_of(section, key), section, key, what));
  }
  void ordered(double least, double most, const char* section, const char* key) const {
    expect(least <= most, section, key,
           fmt::format("expected at least the smallest, {}; got {}", least, most));
  }

 private:
  int line_of(const char* section, const char* key) const {
    int line = 1;
    for (const ConfigEntry& entry : document_.entries) {
      if (entry.section != section) continue;
      line = entry.key_place.line;
      if (entry.key == key) break;
    }
    return line;
  }

  const ConfigDocument& document_;
};

void check(const Course& course, const Plausibility& plausible) {
  const auto strewn = [&plausible](const StrewnParams& params, const char* section) {
    plausible.ordered(params.radius_min_m, params.radius_max_m, section, "radius_max_m");
    plausible.ordered(params.height_min_m, params.height_max_m, section, "height_max_m");
  };
  strewn(course.trees, "trees");
  strewn(course.bushes, "bushes");
  strewn(course.rocks, "rocks");
  plausible.ordered(course.mud.radius_min_m, course.mud.radius_max_m, "mud", "radius_max_m");
  plausible.ordered(course.mud.from_m, course.mud.to_m, "mud", "to_m");
  plausible.ordered(course.terrain.wave_min_m, course.terrain.wave_max_m, "terrain", "wave_max_m");
  plausible.expect(course.trees.at_m.size() % 2 == 0, "trees", "at_m",
                   "expected pairs x, y; the last x has no y");
}

}  // namespace

Ground ground_of(const std::string& name) {
  const Choices names = ground_names();
  const auto found = std::find(names.values.begin(), names.values.end(), name);
  return static_cast<Ground>(found - names.values.begin());
}

Course read_course(const ConfigDocument& document) {
  Course course;
  read_configuration(course, document);
  course.file = document.file_name;
  check(course, Plausibility(document));
  return course;
}

Course load_course(const std::string& path) { return read_course(ConfigDocument::load(path)); }

}  // namespace hindsight
