// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What a vehicle in a simulated world gives to a core, tick by tick: samples at 100 Hz, then a picture. No
// clock and no thread of its own.
#pragma once

#include <cstdint>
#include <optional>

#include "daemon/robot.h"
#include "drivers/frame_pool.h"
#include "drivers/tick_input.h"
#include "sim_replay/renderer/renderer.h"
#include "sim_replay/vehicle/sim_vehicle.h"
#include "sim_replay/world/world.h"

namespace hindsight::tools {

/// The calibrated camera, as the renderer wants it.
RenderCamera render_camera(const CameraModel& model);

class SimFeed {
 public:
  static constexpr Time kStart = from_seconds(1.0);
  /// 2026-01-01 00:00 UTC; a run that repeats bit for bit has no date of its own.
  static constexpr std::int64_t kStartUtime_us = 1'767'225'600'000'000;

  /// `seed`: of the noise of camera, sensors and ground. `truth`: keep each frame's true labels, objects and
  /// depths. FatalError where the renderer cannot work here.
  SimFeed(const RobotSetup& setup, const World& world, std::uint64_t seed, bool truth);

  /// The world moves on for one tick's period and `input` becomes what was seen of it. drive(moment) is
  /// called once a period of the vehicle, with what the vehicle said in it, and returns what its wheels are
  /// told next, or nothing where no command goes out.
  template <typename Drive>
  void advance(TickInput& input, Drive&& drive) {
    begin_tick(input);
    for (const Time until = input.now + period_; input.now + SimVehicle::kPeriod <= until;) {
      move(input);
      command_ = drive(moment_);
    }
    take_picture(input);
  }

  /// Whether the next pictures have their truth.
  void keep_truth(bool truth) { truth_ = truth; }

  const World& world() const { return world_; }
  const SimVehicle& vehicle() const { return vehicle_; }
  const RenderCamera& camera() const { return camera_; }
  const RenderedFrame& rendered() const { return *rendered_; }
  /// Of the body when the newest frame was taken, and when the one before was.
  const BodyPose& X_WB() const { return X_WB_; }
  const BodyPose& X_WB_before() const { return X_WB_before_; }

 private:
  void begin_tick(TickInput& input);
  void move(TickInput& input);
  void take_picture(TickInput& input);

  World world_;
  RenderCamera camera_;
  Renderer renderer_;
  SimVehicle vehicle_;
  FramePool pool_;
  TickInput moment_;  ///< what the vehicle said within its last period
  std::optional<WheelCommand> command_;
  Time period_;
  const RenderedFrame* rendered_ = nullptr;
  BodyPose X_WB_;
  BodyPose X_WB_before_;
  bool truth_;
  bool began_ = false;
};

}  // namespace hindsight::tools
