// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// A course as it is written in a TOML file: what there is and how much of it, not where. Where follows from a
// seed.
#pragma once

#include <cstdint>
#include <string>

#include "config/config_document.h"
#include "sim_replay/world/course_params.h"
#include "sim_replay/world/world.h"

namespace hindsight {

/// Of one of ground_names().
Ground ground_of(const std::string& name);

struct Course {
  std::string file;  ///< for messages; not a parameter
  CourseParams course;
  StartParams start;
  GoalParams goal;
  TreeParams trees;
  BushParams bushes;
  RockParams rocks;
  FenceParams fence;
  PocketParams pocket;
  TrailParams trail;
  MudParams mud;
  TerrainParams terrain;
  LightParams light;

  void visit(auto&& section) {
    section("course", course);
    section("start", start);
    section("goal", goal);
    section("trees", trees);
    section("bushes", bushes);
    section("rocks", rocks);
    section("fence", fence);
    section("pocket", pocket);
    section("trail", trail);
    section("mud", mud);
    section("terrain", terrain);
    section("light", light);
  }
};

/// Strict, as all configuration: FatalError(kExitConfiguration) that names file, line, section and key where
/// one is unknown, of the wrong type or out of range, or where a range is upside down.
Course read_course(const ConfigDocument& document);
/// FatalError(kExitNoInput) where the file cannot be read.
Course load_course(const std::string& path);

/// The same course and seed give the same world, bit for bit; where start and goal lie sways the rest only if
/// it leaves no way between them. FatalError(kExitConfiguration) that names file and objects: start or goal
/// inside an object, no room for what is asked, no way from start to goal in any of a number of drawings.
World build_world(const Course& course, std::uint64_t seed);

}  // namespace hindsight
