// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
// What each driver says at start when its device is not there.
#include "drivers/can_sender.h"
#include "drivers/gpio_lines.h"
#include "drivers/gpsd_client.h"
#include "drivers/socketcan_bus.h"
#include "drivers/v4l2_camera.h"
#include "expect_fatal.h"
#include "recording_sink.h"

namespace hindsight {
namespace {

using std::chrono::milliseconds;

TEST(MissingDevice, Camera) {
  RecordingSink sink;
  FramePool pool(1, 0, 0);
  CameraParams params;
  params.format.device = "/dev/no-camera";
  expect_fatal(kExitNoDevice, {"/dev/no-camera", "No such file"}, [&] { V4l2Camera(params, pool, sink); });
  params.format.device = "/dev/null";
  expect_fatal(kExitNoDevice, {"/dev/null", "not a video device"}, [&] { V4l2Camera(params, pool, sink); });
}

TEST(MissingDevice, CanBus) {
  RecordingSink sink;
  CanBusParams params;
  params.interface = "nocan0";
  expect_fatal(kExitNoDevice, {"nocan0"}, [&] { SocketCanBus(params, {0x100}, sink); });
  expect_fatal(kExitNoDevice, {"nocan0"}, [&] { CanSender("nocan0", {}); });
}

TEST(MissingDevice, GpioChip) {
  RecordingSink sink;
  GpioParams params;
  params.chip = "nogpiochip";
  expect_fatal(kExitNoDevice, {"nogpiochip", "GPIO chip"}, [&] { GpioLines(params, sink); });
}

TEST(MissingDevice, GpsIsAReportOnly) {
  RecordingSink sink;
  GpsParams params;
  params.port = "1";  // nobody listens there
  GpsdClient gps(params, sink);
  gps.service(milliseconds(10));
  ASSERT_EQ(sink.reports.size(), 1U);
  EXPECT_EQ(sink.reports[0].source, Source::gps);
  EXPECT_EQ(sink.reports[0].state, SourceState::failed);
}

}  // namespace
}  // namespace hindsight
