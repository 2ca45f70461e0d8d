// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/flight_recorder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <set>

#include "drivers/frame_decoder.h"
#include "sim_replay/replay_source.h"

namespace hindsight {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr int kWidth_px = 32;
constexpr int kHeight_px = 24;

class FlightRecorderTest : public testing::Test {
 protected:
  FlightRecorderTest() { fs::create_directories(folder_); }
  ~FlightRecorderTest() override { fs::remove_all(folder_); }

  FlightRecorderParams params() const { return {.folder = folder_.string(), .seconds = 2.0, .memory_mb = 1}; }

  /// Tick `index`, a tenth of a second after the one before.
  void tick(FlightRecorder& recorder, std::uint64_t index, StopReason reason,
            StopReason reflex = StopReason::none) {
    TickInput& input = record_.input;
    input.index = index;
    input.now = 100s + index * 100ms;
    input.reflex.stop_reason = static_cast<std::uint8_t>(reflex);
    Frame& frame = slot_.frame;
    frame.stamp = input.now;
    frame.format = PixelFormat::bgr24;
    frame.width_px = kWidth_px;
    frame.height_px = kHeight_px;
    frame.bytes.assign(kWidth_px * kHeight_px * 3, static_cast<std::uint8_t>(index));
    decode_frame(frame);
    input.frame = FrameRef(&slot_);
    record_.reason = reason;
    recorder.take(record_);
    input.frame = {};
    recorder.look_after(input.now);
  }

  std::set<fs::path> files() const {
    std::set<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder_)) found.insert(entry.path());
    return found;
  }

  fs::path folder_ = fs::temp_directory_path() / ("hindsight_flight_" + std::to_string(getpid()));
  FrameSlot slot_;
  TickRecord record_;
};

std::vector<TickInput> read_ticks(const fs::path& file, FramePool& pool) {
  ReplaySource source(file, pool, [](Frame& frame) { return decode_frame(frame) == DecodeResult::ok; });
  std::vector<TickInput> ticks;
  TickInput tick;
  tick.reserve();
  while (source.next(tick)) {
    ticks.push_back(tick);
    ticks.back().frame = {};
  }
  return ticks;
}

TEST_F(FlightRecorderTest, AFaultLeavesALogOfTheSecondsBeforeAndOneAfter) {
  FlightRecorder recorder(params(), {});
  for (std::uint64_t i = 0; i < 50; ++i) tick(recorder, i, StopReason::none);
  for (std::uint64_t i = 50; i < 70; ++i) tick(recorder, i, StopReason::camera, StopReason::camera);
  ASSERT_EQ(files().size(), 1U);
  EXPECT_NE(files().begin()->string().find("camera"), std::string::npos);
  FramePool pool(4, 0, 0);
  const std::vector<TickInput> ticks = read_ticks(*files().begin(), pool);
  ASSERT_EQ(ticks.size(), 21U) << "2 s";
  EXPECT_EQ(ticks.front().index, 40U);
  EXPECT_EQ(ticks.back().index, 60U) << "a second after the fault";
}

TEST_F(FlightRecorderTest, AnOperatorsStopLeavesNothing) {
  FlightRecorder recorder(params(), {});
  for (const StopReason stop : {StopReason::operator_stop, StopReason::not_armed, StopReason::bumper}) {
    for (std::uint64_t i = 0; i < 5; ++i) tick(recorder, i, StopReason::none);
    for (std::uint64_t i = 5; i < 30; ++i) tick(recorder, i, stop);
  }
  EXPECT_TRUE(files().empty());
}

TEST_F(FlightRecorderTest, AFaultOfAVehicleThatStandsAnywayLeavesNothing) {
  FlightRecorder recorder(params(), {});
  for (std::uint64_t i = 0; i < 30; ++i)
    tick(recorder, i, i < 5 ? StopReason::not_armed : StopReason::camera);
  EXPECT_TRUE(files().empty());
}

TEST_F(FlightRecorderTest, AStopOfTheReflexAloneIsAFaultToo) {
  FlightRecorder recorder(params(), {});
  for (std::uint64_t i = 0; i < 30; ++i) {
    tick(recorder, i, StopReason::none, i == 10 ? StopReason::stale_command : StopReason::none);
  }
  ASSERT_EQ(files().size(), 1U);
}

TEST_F(FlightRecorderTest, TheEndOrARequestDoesNotWait) {
  {
    FlightRecorder recorder(params(), {});
    tick(recorder, 0, StopReason::none);
    tick(recorder, 1, StopReason::wheels);
  }
  EXPECT_EQ(files().size(), 1U) << "ended right after the fault";
  FlightRecorder recorder(params(), {});
  tick(recorder, 0, StopReason::none);
  recorder.request(StopReason::thread);
  EXPECT_FALSE(recorder.idle());
  recorder.look_after(101s);
  EXPECT_TRUE(recorder.idle());
  EXPECT_EQ(files().size(), 2U);
}

TEST_F(FlightRecorderTest, KeepsSoManyFilesAndTouchesNoOthers) {
  for (const char* name :
       {"fault_20200101T000000Z_camera.lcm", "fault_20200102T000000Z_camera.lcm", "notes.txt"}) {
    std::fclose(std::fopen((folder_ / name).c_str(), "w"));
  }
  FlightRecorderParams few = params();
  few.files = 2;
  FlightRecorder recorder(few, {});
  tick(recorder, 0, StopReason::none);
  recorder.request(StopReason::thread);
  recorder.look_after(101s);
  const std::set<fs::path> left = files();
  EXPECT_EQ(left.size(), 3U);
  EXPECT_FALSE(left.contains(folder_ / "fault_20200101T000000Z_camera.lcm"));
  EXPECT_TRUE(left.contains(folder_ / "notes.txt"));
}

}  // namespace
}  // namespace hindsight
