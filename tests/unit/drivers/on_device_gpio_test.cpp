// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "drivers/gpio_lines.h"
#include "expect_fatal.h"
#include "on_device.h"

namespace hindsight {
namespace {

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
