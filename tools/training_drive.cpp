// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/training_drive.h"

#include "daemon/run_setup.h"
#include "perception/mixture_codec.h"
#include "tools/builtin_config.h"
#include "tools/sim_run.h"

namespace hindsight::tools {
namespace {

std::vector<RobotSetup> setups_for(const std::vector<Arm>& arms) {
  std::vector<RobotSetup> setups;
  for (const Arm& arm : arms)
    setups.push_back(make_setup(arm.configuration, sim_materials(arm.configuration, {}), arm.name));
  return setups;
}

Arm without_reverse_flow(std::string name, Configuration configuration) {
  configuration.reverse_flow.reverse_flow = false;
  return {std::move(name), configuration};
}

Configuration without_texture() {
  Configuration configuration;
  configuration.labels.texture = false;
  return configuration;
}

}  // namespace

std::vector<Arm> segmentation_arms() {
  return {without_reverse_flow("no_reverse_flow", thesis_configuration()),
          {"thesis", thesis_configuration()},
          without_reverse_flow("color_no_reverse_flow", without_texture()),
          {"color", without_texture()},
          without_reverse_flow("default_no_reverse_flow", Configuration{}),
          {"default", Configuration{}}};
}

TrainingDrive::TrainingDrive(const World& world, std::uint64_t seed, int bumps, const std::vector<Arm>& arms)
    : setups_(setups_for(arms)),
      feed_(setups_.front(), world, seed, true),
      guide_(world, setups_.front().configuration.vehicle.track_width_m, bumps) {
  for (const RobotSetup& setup : setups_) robots_.push_back(std::make_unique<Robot>(setup));
}

void TrainingDrive::step() {
  feed_.advance(input_,
                [this](const TickInput& moment) { return guide_.drive(feed_.vehicle(), moment.now); });
  for (const auto& robot : robots_) {
    outbox_.clear();
    robot->step(input_, outbox_);
  }
}

std::vector<std::uint8_t> TrainingDrive::mixture(std::size_t arm) const {
  return encode_mixture(robots_[arm]->learner().snapshot());
}

}  // namespace hindsight::tools
