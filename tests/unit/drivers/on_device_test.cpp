// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The drivers on real kernel interfaces, with the faults that the kernel's fake hardware can make. They
// change the machine's devices, so they run only where HINDSIGHT_DESK is set: as root in the user-mode Linux
// of tests/desk, with vivid at /dev/video0, v4l2loopback at /dev/video10, vcan, and gpio-sim through
// configfs.
#include <fcntl.h>
#include <linux/can.h>
#include <linux/can/error.h>
#include <linux/videodev2.h>
#include <sys/eventfd.h>
#include <sys/ioctl.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <thread>

#include "drivers/can_sender.h"
#include "drivers/gpio_lines.h"
#include "drivers/monotonic_clock.h"
#include "drivers/socketcan_bus.h"
#include "drivers/v4l2_camera.h"
#include "expect_fatal.h"
#include "recording_sink.h"

namespace hindsight {
namespace {

using std::chrono::milliseconds;

class OnDevice : public testing::Test {
 protected:
  void SetUp() override {
    if (std::getenv("HINDSIGHT_DESK") == nullptr) GTEST_SKIP() << "HINDSIGHT_DESK is not set";
  }
  /// Serves the driver until `done`, at most for `limit`; says whether it got there.
  template <class Driver>
  bool serve(Driver& driver, std::function<bool()> done, Time limit = milliseconds(4000)) {
    const Time end = monotonic_now() + limit;
    while (!done() && monotonic_now() < end) driver.service(milliseconds(20));
    return done();
  }
  RecordingSink sink_;
};

bool run(const std::string& command) { return std::system(command.c_str()) == 0; }

// ---- vivid

class Vivid : public OnDevice {
 protected:
  static CameraParams params() {
    CameraParams result;
    result.format.device = "/dev/video0";
    result.format.width_px = 640;
    result.format.height_px = 360;
    result.format.rate_hz = 30;
    result.restart_s = 1.0;
    return result;
  }
  /// Sets a control of vivid by its name, through a descriptor of its own.
  static void set_control(const char* name, int value) {
    const UniqueFd fd(::open("/dev/video0", O_RDWR | O_CLOEXEC));
    v4l2_queryctrl query{};
    query.id = V4L2_CTRL_FLAG_NEXT_CTRL;
    while (::ioctl(fd.get(), VIDIOC_QUERYCTRL, &query) == 0) {
      if (std::string(reinterpret_cast<const char*>(query.name)) == name) {
        v4l2_control control{.id = query.id, .value = value};
        ASSERT_EQ(::ioctl(fd.get(), VIDIOC_S_CTRL, &control), 0) << name;
        return;
      }
      query.id |= V4L2_CTRL_FLAG_NEXT_CTRL;
    }
    FAIL() << "no control " << name;
  }
  bool serve_until(V4l2Camera& camera, SourceState state) {
    return serve(camera, [&] { return sink_.last_state_is(state); });
  }
  FramePool pool_{6, 1280 * 720 * 2, 1280 * 720};
};

TEST_F(Vivid, StreamsWithKernelStamps) {
  const Time before = monotonic_now();
  V4l2Camera camera(params(), pool_, sink_);
  ASSERT_TRUE(serve(camera, [&] { return sink_.frame_stamps.size() >= 10; }));
  for (std::size_t i = 0; i < sink_.frame_stamps.size(); ++i) {
    EXPECT_GT(sink_.frame_stamps[i], i == 0 ? before : sink_.frame_stamps[i - 1]);
    EXPECT_LE(sink_.frame_stamps[i], monotonic_now());
  }
  EXPECT_EQ(sink_.last_frame->bytes.size(), 640U * 360U * 2U);
  EXPECT_EQ(sink_.last_frame->bgr.size(), 640U * 360U * 3U);
  EXPECT_GT(sink_.last_frame->gain, 0.0F) << "vivid tells its gain";
  EXPECT_EQ(sink_.reports.front().state, SourceState::fresh);
}

TEST_F(Vivid, AnotherSizeIsRefusedSayingBoth) {
  CameraParams wrong = params();
  wrong.format.width_px = 700;
  expect_fatal(kExitNoDevice, {"/dev/video0", "asked for 700 x 360 YUYV", "gives 640 x 360 YUYV"},
               [&] { V4l2Camera(wrong, pool_, sink_); });
}

TEST_F(Vivid, AnotherFormatIsRefusedSayingBoth) {
  CameraParams wrong = params();
  wrong.format.format = "mjpeg";
  expect_fatal(kExitNoDevice, {"/dev/video0", "asked for 640 x 360 MJPG", "gives 640 x 360 YUYV"},
               [&] { V4l2Camera(wrong, pool_, sink_); });
}

TEST_F(Vivid, ABusyCameraIsRefused) {
  const V4l2Camera first(params(), pool_, sink_);
  expect_fatal(kExitNoDevice, {"/dev/video0", "busy"}, [&] { V4l2Camera(params(), pool_, sink_); });
}

TEST_F(Vivid, ALateServiceGetsTheNewestFrame) {
  V4l2Camera camera(params(), pool_, sink_);
  ASSERT_TRUE(serve_until(camera, SourceState::fresh));
  std::this_thread::sleep_for(milliseconds(110));
  const std::size_t before = sink_.frame_stamps.size();
  camera.service(milliseconds(20));
  EXPECT_EQ(sink_.frame_stamps.size(), before + 1);
  EXPECT_GE(camera.statistics().outdated, 1U);
}

TEST_F(Vivid, AHeldPoolCostsFramesOnly) {
  FramePool small(1, 640 * 360 * 2, 640 * 360);
  V4l2Camera camera(params(), small, sink_);
  ASSERT_TRUE(serve(camera, [&] { return camera.statistics().no_slot >= 3; }))
      << "the sink holds the only slot";
  sink_.last_frame = {};
  ASSERT_TRUE(serve(camera, [&] { return camera.statistics().delivered >= 2; }));
}

TEST_F(Vivid, ComesBackAfterADisconnection) {
  V4l2Camera camera(params(), pool_, sink_);
  ASSERT_TRUE(serve_until(camera, SourceState::fresh));
  const Time unplugged = monotonic_now();
  set_control("Disconnect", 1);
  ASSERT_TRUE(serve_until(camera, SourceState::failed));
  EXPECT_LT(sink_.reports.back().stamp - unplugged, milliseconds(300));
  EXPECT_EQ(sink_.reports.back().error_code, ENODEV);
  ASSERT_TRUE(serve_until(camera, SourceState::fresh));
  EXPECT_GE(camera.statistics().reopened, 1U);
}

TEST_F(Vivid, AStallIsToldAndCuredByReopening) {
  V4l2Camera camera(params(), pool_, sink_);
  ASSERT_TRUE(serve_until(camera, SourceState::fresh));
  set_control("Percentage of Dropped Buffers", 100);
  const Time stalled = monotonic_now();
  ASSERT_TRUE(serve_until(camera, SourceState::stale));
  EXPECT_LT(sink_.reports.back().stamp - stalled, milliseconds(400));
  ASSERT_TRUE(serve_until(camera, SourceState::failed));
  EXPECT_EQ(sink_.reports.back().error_code, ETIMEDOUT);
  set_control("Percentage of Dropped Buffers", 0);
  EXPECT_TRUE(serve_until(camera, SourceState::fresh));
}

TEST_F(Vivid, BrokenBuffersAreDroppedAndCounted) {
  V4l2Camera camera(params(), pool_, sink_);
  ASSERT_TRUE(serve_until(camera, SourceState::fresh));
  for (int i = 0; i < 5; ++i) {
    set_control("Inject V4L2_BUF_FLAG_ERROR", 1);
    ASSERT_TRUE(serve(camera, [&] { return camera.statistics().frames.broken > static_cast<unsigned>(i); }))
        << i;
  }
  EXPECT_TRUE(serve(camera, [&] { return sink_.reports.back().dropped >= 5; }));
}

TEST_F(Vivid, AStopRequestWakesIt) {
  CameraParams slow = params();
  V4l2Camera camera(slow, pool_, sink_);
  const UniqueFd stop(::eventfd(1, EFD_CLOEXEC | EFD_NONBLOCK));
  const Time before = monotonic_now();
  camera.service(milliseconds(10000), stop.get());
  EXPECT_LT(monotonic_now() - before, milliseconds(200));
}

// ---- v4l2loopback

class Loopback : public OnDevice {
 protected:
  static constexpr int kWidth = 720;
  static constexpr int kHeight = 480;

  /// A program that feeds the loopback camera. `make` gives the bytes of frame i.
  class Feeder {
   public:
    Feeder(std::uint32_t fourcc, std::function<std::vector<std::uint8_t>(int)> make)
        : fd_(::open("/dev/video10", O_RDWR | O_CLOEXEC)) {
      v4l2_format format{};
      format.type = V4L2_BUF_TYPE_VIDEO_OUTPUT;
      format.fmt.pix.width = kWidth;
      format.fmt.pix.height = kHeight;
      format.fmt.pix.pixelformat = fourcc;
      format.fmt.pix.field = V4L2_FIELD_NONE;
      format.fmt.pix.sizeimage = kWidth * kHeight * 2;
      EXPECT_EQ(::ioctl(fd_.get(), VIDIOC_S_FMT, &format), 0);
      feed(make(0));
      thread_ = std::thread([this, make] {
        for (int i = 1; !stop_; ++i) {
          std::this_thread::sleep_for(milliseconds(30));
          if (!paused_) feed(make(i));
        }
      });
    }
    ~Feeder() {
      stop_ = true;
      thread_.join();
    }
    std::atomic<bool> paused_{false};

   private:
    void feed(const std::vector<std::uint8_t>& bytes) {
      EXPECT_EQ(::write(fd_.get(), bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
    }
    UniqueFd fd_;
    std::atomic<bool> stop_{false};
    std::thread thread_;
  };

  static std::vector<std::uint8_t> grey(int i) {
    std::vector<std::uint8_t> bytes(kWidth * kHeight * 2, 128);
    for (std::size_t k = 0; k < bytes.size(); k += 2) bytes[k] = static_cast<std::uint8_t>(16 + i % 200);
    return bytes;
  }
  static CameraParams params(const char* format) {
    CameraParams result;
    result.format.device = "/dev/video10";
    result.format.format = format;
    return result;
  }
  FramePool pool_{6, kWidth* kHeight * 2, kWidth* kHeight};
};

TEST_F(Loopback, GivesWhatWasFed) {
  Feeder feeder(V4L2_PIX_FMT_YUYV, grey);
  V4l2Camera camera(params("yuyv"), pool_, sink_);
  ASSERT_TRUE(serve(camera, [&] { return sink_.frame_stamps.size() >= 10; }));
  const std::uint8_t luma = sink_.last_frame->bytes[0];
  EXPECT_EQ(sink_.last_frame->bytes, grey(luma - 16));
  EXPECT_LE(sink_.frame_stamps.back(), monotonic_now());
  EXPECT_GT(sink_.frame_stamps.back(), monotonic_now() - milliseconds(500));
  EXPECT_EQ(camera.statistics().frames.wrong_length, 0U);
}

TEST_F(Loopback, AFeederThatPausesIsAStall) {
  Feeder feeder(V4L2_PIX_FMT_YUYV, grey);
  V4l2Camera camera(params("yuyv"), pool_, sink_);
  ASSERT_TRUE(serve(camera, [&] { return sink_.last_state_is(SourceState::fresh); }));
  feeder.paused_ = true;
  ASSERT_TRUE(serve(camera, [&] { return sink_.last_state_is(SourceState::stale); }));
  feeder.paused_ = false;
  EXPECT_TRUE(serve(camera, [&] { return sink_.last_state_is(SourceState::fresh); }));
}

TEST_F(Loopback, AJpegThatIsNoneIsDroppedAndCounted) {
  Feeder feeder(V4L2_PIX_FMT_MJPEG,
                [](int i) { return std::vector<std::uint8_t>(1000 + static_cast<std::size_t>(i), 7); });
  V4l2Camera camera(params("mjpeg"), pool_, sink_);
  EXPECT_TRUE(serve(camera, [&] { return camera.statistics().undecodable >= 5; }));
  EXPECT_TRUE(sink_.frame_stamps.empty());
}

TEST_F(Loopback, AnotherSizeIsRefusedSayingBoth) {
  Feeder feeder(V4L2_PIX_FMT_YUYV, grey);
  CameraParams wrong = params("yuyv");
  wrong.format.width_px = 640;
  expect_fatal(kExitNoDevice, {"/dev/video10", "640 x 480", "720 x 480"},
               [&] { V4l2Camera(wrong, pool_, sink_); });
}

// ---- vcan

class Vcan : public OnDevice {
 protected:
  void SetUp() override {
    OnDevice::SetUp();
    if (IsSkipped()) return;
    run("ip link del vcan7 2> /dev/null");
    ASSERT_TRUE(run("ip link add vcan7 type vcan && ip link set vcan7 up"));
  }
  void TearDown() override {
    if (!IsSkipped()) run("ip link del vcan7 2> /dev/null");
  }
  static CanBusParams params() {
    CanBusParams result;
    result.interface = "vcan7";
    return result;
  }
  static CanFrame frame(std::uint32_t id, std::uint8_t first = 0) {
    return {.id = id, .length = 8, .data = {first}};
  }
};

TEST_F(Vcan, CarriesFramesWithTheirTimes) {
  SocketCanBus bus(params(), {0x100, 0x101}, sink_);
  CanSender sender("vcan7", {});
  const Time before = monotonic_now();
  for (std::uint8_t i = 0; i < 100; ++i) EXPECT_EQ(sender.send(frame(0x100 + i % 2U, i), before), 0);
  ASSERT_TRUE(serve(bus, [&] { return sink_.can.size() >= 100; }));
  for (std::size_t i = 0; i < 100; ++i) {
    EXPECT_EQ(sink_.can[i].id, 0x100 + i % 2);
    EXPECT_EQ(sink_.can[i].data[0], i);
    EXPECT_EQ(sink_.can[i].length, 8);
    EXPECT_GE(sink_.can[i].stamp, before - milliseconds(1));
    EXPECT_LE(sink_.can[i].stamp, monotonic_now());
  }
  EXPECT_TRUE(sink_.last_state_is(SourceState::fresh));
}

TEST_F(Vcan, StampsSayWhenAFrameCameNotWhenItWasRead) {
  SocketCanBus bus(params(), {0x100}, sink_);
  CanSender sender("vcan7", {});
  sender.send(frame(0x100), monotonic_now());
  const Time sent = monotonic_now();
  std::this_thread::sleep_for(milliseconds(200));
  ASSERT_TRUE(serve(bus, [&] { return !sink_.can.empty(); }));
  EXPECT_LT(sink_.can[0].stamp, sent + milliseconds(50));
}

TEST_F(Vcan, OnlyTheWantedIdentifiersAndErrorFramesComeIn) {
  SocketCanBus bus(params(), {0x100, 0x105 | CAN_EFF_FLAG}, sink_);
  CanSender sender("vcan7", {});
  for (const std::uint32_t id : {0x0FFU, 0x101U, 0x105U, 0x100U | CAN_EFF_FLAG, 0x100U | CAN_RTR_FLAG}) {
    sender.send(frame(id), {});
  }
  sender.send(frame(CAN_ERR_FLAG | CAN_ERR_BUSOFF), {});
  sender.send(frame(0x105 | CAN_EFF_FLAG), {});
  ASSERT_TRUE(serve(bus, [&] { return sink_.can.size() >= 2; }));
  EXPECT_EQ(sink_.can.size(), 2U);
  EXPECT_EQ(sink_.can[0].id, CAN_ERR_FLAG | CAN_ERR_BUSOFF);
  EXPECT_EQ(sink_.can[1].id, 0x105 | CAN_EFF_FLAG);
}

TEST_F(Vcan, AFloodIsBoundedAndItsLossesAreCounted) {
  SocketCanBus bus(params(), {0x100}, sink_);
  CanSender sender("vcan7", {});
  for (int i = 0; i < 5000; ++i) sender.send(frame(0x100), {});
  bus.service(milliseconds(20));
  EXPECT_LE(sink_.can.size(), 256U + 32U);
  serve(
      bus, [] { return false; }, milliseconds(200));
  sender.send(frame(0x100), {});  // losses are told with the next frame
  ASSERT_TRUE(serve(bus, [&] { return !sink_.reports.empty() && sink_.reports.back().dropped > 0; }));
  EXPECT_EQ(sink_.can.size() + sink_.reports.back().dropped, 5001U);
}

TEST_F(Vcan, ComesBackAfterTheLinkWasDown) {
  SocketCanBus bus(params(), {0x100}, sink_);
  CanSender sender("vcan7", {});
  ASSERT_TRUE(run("ip link set vcan7 down"));
  ASSERT_TRUE(serve(bus, [&] { return sink_.last_state_is(SourceState::failed); }));
  EXPECT_EQ(sink_.reports.back().error_code, ENETDOWN);
  EXPECT_EQ(sender.send(frame(0x100), monotonic_now()), ENETDOWN);
  ASSERT_TRUE(run("ip link set vcan7 up"));
  EXPECT_TRUE(serve(bus, [&] {
    sender.send(frame(0x100), monotonic_now());
    return sink_.last_state_is(SourceState::fresh);
  }));
}

TEST_F(Vcan, ComesBackAfterTheInterfaceWasGone) {
  SocketCanBus bus(params(), {0x100}, sink_);
  CanSender sender("vcan7", {});
  ASSERT_TRUE(run("ip link del vcan7"));
  ASSERT_TRUE(serve(bus, [&] { return sink_.last_state_is(SourceState::failed); }));
  EXPECT_NE(sender.send(frame(0x100), monotonic_now()), 0);
  ASSERT_TRUE(run("ip link add vcan7 type vcan && ip link set vcan7 up"));
  EXPECT_TRUE(serve(bus, [&] {
    sender.send(frame(0x100), monotonic_now());
    return sink_.last_state_is(SourceState::fresh);
  }));
}

TEST_F(Vcan, ALinkThatIsDownAtStartIsRefused) {
  ASSERT_TRUE(run("ip link set vcan7 down"));
  expect_fatal(kExitNoDevice, {"vcan7", "down"}, [&] { SocketCanBus(params(), {0x100}, sink_); });
  expect_fatal(kExitNoDevice, {"vcan7", "down"}, [&] { CanSender("vcan7", {}); });
}

// ---- gpio-sim

class GpioSim : public OnDevice {
 protected:
  void SetUp() override {
    OnDevice::SetUp();
    if (!IsSkipped()) plug_in();
  }
  void TearDown() override {
    if (!IsSkipped()) unplug();
  }
  static constexpr const char* kLabel = "desk-lines";
  static constexpr const char* kFolder = "/sys/kernel/config/gpio-sim/desk";

  static void write_file(const std::string& path, const std::string& text) {
    std::ofstream file(path);
    file << text << std::flush;
    EXPECT_TRUE(file.good()) << path;
  }
  static std::string read_file(const std::string& path) {
    std::string text;
    std::getline(std::ifstream(path) >> std::ws, text);
    return text;
  }
  void plug_in() {
    const std::string folder = kFolder;
    const std::string bank = folder + "/bank0";
    std::filesystem::create_directories(bank);
    write_file(bank + "/num_lines", "8");
    write_file(bank + "/label", kLabel);
    const std::vector<std::string> names{"", "", "", "bumper_left", "bumper_right", "estop"};
    for (std::size_t i = 3; i < names.size(); ++i) {
      const std::string line = bank + "/line" + std::to_string(i);
      std::filesystem::create_directory(line);
      write_file(line + "/name", names[i]);
    }
    write_file(folder + "/live", "1");
    chip_ = read_file(bank + "/chip_name");
    device_ = read_file(folder + "/dev_name");
  }
  void unplug() {
    const std::string folder = kFolder;
    if (!std::filesystem::exists(folder)) return;
    write_file(folder + "/live", "0");
    for (const char* line : {"/bank0/line3", "/bank0/line4", "/bank0/line5", "/bank0", ""})
      ::rmdir((folder + line).c_str());
  }
  void pull(int line, bool up) {
    write_file(
        "/sys/devices/platform/" + device_ + "/" + chip_ + "/sim_gpio" + std::to_string(line) + "/pull",
        up ? "pull-up" : "pull-down");
  }
  static GpioParams params() {
    GpioParams result;
    result.chip = kLabel;  // the chip's name may be another each time that it is plugged in
    return result;
  }
  std::string chip_;
  std::string device_;
};

TEST_F(GpioSim, TellsLevelsAtStartAndThenEdges) {
  pull(5, true);
  GpioLines gpio(params(), sink_);
  ASSERT_EQ(sink_.edges.size(), 3U);
  EXPECT_FALSE(sink_.edges[0].active);
  EXPECT_FALSE(sink_.edges[1].active);
  EXPECT_EQ(sink_.edges[2].line, Line::estop);
  EXPECT_TRUE(sink_.edges[2].active);
  EXPECT_TRUE(sink_.last_state_is(SourceState::fresh));
  const Time before = monotonic_now();
  pull(3, true);
  const Time after = monotonic_now();
  std::this_thread::sleep_for(milliseconds(50));
  ASSERT_TRUE(serve(gpio, [&] { return sink_.edges.size() >= 4; }));
  EXPECT_EQ(sink_.edges[3].line, Line::bumper_left);
  EXPECT_TRUE(sink_.edges[3].active);
  EXPECT_GE(sink_.edges[3].stamp, before);
  EXPECT_LE(sink_.edges[3].stamp, after + milliseconds(20)) << "the kernel's time, not the reading's";
  pull(3, false);
  ASSERT_TRUE(serve(gpio, [&] { return sink_.edges.size() >= 5; }));
  EXPECT_FALSE(sink_.edges[4].active);
}

TEST_F(GpioSim, APulseTooShortForTheKernelIsStillToldOnce) {
  GpioLines gpio(params(), sink_);
  const std::size_t before = sink_.edges.size();
  pull(4, true);
  pull(4, false);
  serve(
      gpio, [] { return false; }, milliseconds(100));
  ASSERT_EQ(sink_.edges.size(), before + 2);
  EXPECT_TRUE(sink_.edges[before].active);
  EXPECT_FALSE(sink_.edges[before + 1].active);
}

TEST_F(GpioSim, EachOfManyEdgesComesOnce) {
  GpioLines gpio(params(), sink_);
  const std::size_t before = sink_.edges.size();
  for (int i = 0; i < 10; ++i) {
    pull(4, i % 2 == 0);
    std::this_thread::sleep_for(milliseconds(20));  // gpio-sim makes its interrupts at timer ticks
  }
  serve(
      gpio, [] { return false; }, milliseconds(100));
  EXPECT_EQ(sink_.edges.size(), before + 10);
  EXPECT_FALSE(sink_.edges.back().active);
}

TEST_F(GpioSim, AnOverflowEndsWithTheTrueLevel) {
  GpioLines gpio(params(), sink_);
  for (int i = 0; i < 101; ++i) pull(4, i % 2 == 0);
  serve(
      gpio, [] { return false; }, milliseconds(100));
  EXPECT_TRUE(sink_.edges.back().active);
}

TEST_F(GpioSim, ActiveLowTurnsTheLevelRound) {
  GpioParams low = params();
  low.estop_active_low = true;
  GpioLines gpio(low, sink_);
  EXPECT_TRUE(sink_.edges.at(2).active) << "a cut wire reads as pressed";
  pull(5, true);
  ASSERT_TRUE(serve(gpio, [&] { return sink_.edges.size() >= 4; }));
  EXPECT_FALSE(sink_.edges[3].active);
}

TEST_F(GpioSim, LinesMayBeGivenByOffset) {
  GpioParams offsets = params();
  offsets.bumper_left = "0";
  offsets.bumper_right = "";
  offsets.estop = "";
  GpioLines gpio(offsets, sink_);
  pull(0, true);
  ASSERT_TRUE(serve(gpio, [&] { return sink_.edges.size() >= 2; }));
  EXPECT_EQ(sink_.edges[1].line, Line::bumper_left);
  EXPECT_TRUE(sink_.edges[1].active);
}

TEST_F(GpioSim, AbsentAndBusyLinesAreRefusedByName) {
  GpioParams absent = params();
  absent.estop = "red_button";
  expect_fatal(kExitNoDevice, {kLabel, "red_button"}, [&] { GpioLines(absent, sink_); });
  absent.estop = "99";
  expect_fatal(kExitNoDevice, {kLabel, "line 99"}, [&] { GpioLines(absent, sink_); });
  const GpioLines first(params(), sink_);
  expect_fatal(kExitNoDevice, {kLabel, "bumper_left", "busy"}, [&] { GpioLines(params(), sink_); });
}

TEST_F(GpioSim, ComesBackAfterTheChipWasGone) {
  GpioLines gpio(params(), sink_);
  unplug();
  const Time unplugged = monotonic_now();
  ASSERT_TRUE(serve(gpio, [&] { return sink_.last_state_is(SourceState::failed); }));
  EXPECT_LT(sink_.reports.back().stamp - unplugged, milliseconds(100));
  plug_in();
  pull(3, true);
  ASSERT_TRUE(serve(gpio, [&] { return sink_.last_state_is(SourceState::fresh); }))
      << "errno " << sink_.reports.back().error_code;
  EXPECT_TRUE(sink_.edges.at(sink_.edges.size() - 3).active) << "levels are told anew";
}

}  // namespace
}  // namespace hindsight
