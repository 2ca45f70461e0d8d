// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Publishes a state, a pose, a grid and a picture ten times a second until it is killed: something for
// lcm-spy to show. The grid has a lethal half; the picture is one colour.
#include <chrono>
#include <cstdint>
#include <lcm/lcm-cpp.hpp>
#include <opencv2/imgcodecs.hpp>
#include <thread>
#include <vector>

#include "bot_core/image_t.hpp"
#include "bot_core/pose_t.hpp"
#include "hindsight/grid_t.hpp"
#include "hindsight/state_t.hpp"

namespace {

bot_core::image_t picture() {
  std::vector<std::uint8_t> jpeg;
  cv::imencode(".jpg", cv::Mat(120, 160, CV_8UC3, cv::Scalar(200, 40, 40)), jpeg);
  bot_core::image_t message{};
  message.width = 160;
  message.height = 120;
  message.pixelformat = 1196444237;
  message.data.assign(jpeg.begin(), jpeg.end());
  message.size = static_cast<std::int32_t>(jpeg.size());
  return message;
}

hindsight::grid_t half_lethal_grid() {
  hindsight::grid_t message{};
  message.width = 40;
  message.height = 40;
  message.resolution_m = 0.2F;
  message.size = message.width * message.height;
  message.cost.assign(static_cast<std::size_t>(message.size), 0);
  std::fill(message.cost.begin() + message.size / 2, message.cost.end(), 2);
  return message;
}

}  // namespace

int main() {
  lcm::LCM bus;
  if (!bus.good()) return 69;
  const bot_core::image_t preview = picture();
  const hindsight::grid_t grid = half_lethal_grid();
  hindsight::state_t state{};
  bot_core::pose_t pose{};
  for (;; ++state.tick) {
    state.position_m[0] = pose.pos[0] = 0.05 * static_cast<double>(state.tick);
    bus.publish("HINDSIGHT_STATE", &state);
    bus.publish("POSE", &pose);
    bus.publish("HINDSIGHT_GRID", &grid);
    bus.publish("HINDSIGHT_PREVIEW", &preview);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
}
