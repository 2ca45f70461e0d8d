// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The thesis' training drive (5.2.2): a guided vehicle meets some trees, then drives on; several cores see
// the same samples at once and learn from them, each with a configuration of its own.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tools/guide.h"
#include "tools/sim_feed.h"

namespace hindsight::tools {

/// One way to do it that is compared with others.
struct Arm {
  std::string name;
  Configuration configuration;
};

/// The thesis' comparison, and ours: "no_reverse_flow" and "thesis" have the thesis' numbers but learn from
/// patches as they look now, or as they looked from afar; "default_no_reverse_flow" and "default" likewise
/// with the defaults, "color_no_reverse_flow" and "color" with the defaults but without texture.
std::vector<Arm> segmentation_arms();

class TrainingDrive {
 public:
  TrainingDrive(const World& world, std::uint64_t seed, int bumps, const std::vector<Arm>& arms);

  void step();
  /// All trees that were to be met have been.
  bool trained() const { return guide_.touring(); }
  int touches() const { return feed_.vehicle().touches(); }

  const SimFeed& feed() const { return feed_; }
  const TickInput& input() const { return input_; }
  const CameraModel& camera() const { return setups_.front().camera; }
  const Robot& robot(std::size_t arm) const { return *robots_[arm]; }
  /// What the arm's mixture would be saved as now.
  std::vector<std::uint8_t> mixture(std::size_t arm) const;

 private:
  std::vector<RobotSetup> setups_;
  SimFeed feed_;
  Guide guide_;
  std::vector<std::unique_ptr<Robot>> robots_;
  TickInput input_;
  Outbox outbox_;
};

}  // namespace hindsight::tools
