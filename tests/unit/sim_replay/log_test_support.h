// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "config/exit_code.h"
#include "drivers/frame_pool.h"
#include "drivers/tick_input.h"
#include "sim_replay/replay_source.h"
#include "sim_replay/run_log_writer.h"

namespace hindsight::test {

/// A folder of its own for each test, removed afterwards.
class TempFolder {
 public:
  TempFolder() {
    const auto* const info = testing::UnitTest::GetInstance()->current_test_info();
    // In memory where that can be had: thousands of small logs are written here.
    const std::filesystem::path memory = "/dev/shm";
    std::string name = "hindsight_" + std::string(info->test_suite_name()) + "_" + info->name() + "_" +
                       std::to_string(::getpid());
    std::replace(name.begin(), name.end(), '/', '_');  // of parameterised tests
    path_ = (std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path()) / name;
    std::filesystem::create_directories(path_);
  }
  ~TempFolder() { std::filesystem::remove_all(path_); }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

using Bytes = std::vector<std::uint8_t>;

inline Bytes read_bytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

inline void write_bytes(const std::filesystem::path& path, const Bytes& bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

inline void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path) << text;
}

/// The message of the FatalError that `f` throws, which must have this code; empty if it throws none.
inline std::string fatal_message(ExitCode code, const std::function<void()>& f) {
  try {
    f();
  } catch (const FatalError& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    return error.what();
  }
  return {};
}

inline bool decode_bgr24(Frame& frame) {
  frame.bgr = frame.bytes;
  return frame.format == PixelFormat::bgr24 &&
         frame.bytes.size() ==
             static_cast<std::size_t>(frame.width_px) * static_cast<std::size_t>(frame.height_px) * 3;
}

class RandomSamples {
 public:
  explicit RandomSamples(std::uint32_t seed) : engine_(seed) {}

  std::uint32_t word() { return static_cast<std::uint32_t>(engine_()); }
  std::uint32_t below(std::uint32_t bound) { return word() % bound; }
  double real() { return std::uniform_real_distribution<double>(-1e6, 1e6)(engine_); }

  void fill(Frame& frame, Time stamp) {
    frame.stamp = stamp;
    frame.sequence = word();
    frame.format = PixelFormat::bgr24;
    frame.width_px = 4;
    frame.height_px = 2;
    frame.exposure_s = static_cast<float>(real());
    frame.gain = static_cast<float>(real());
    frame.bytes.resize(24);
    for (auto& byte : frame.bytes) byte = static_cast<std::uint8_t>(word());
  }
  CanFrame can(Time stamp) {
    CanFrame frame{stamp, word(), static_cast<std::uint8_t>(below(9)), {}};
    for (auto& byte : frame.data) byte = static_cast<std::uint8_t>(word());
    return frame;
  }
  LineEdge edge(Time stamp) { return {stamp, static_cast<Line>(below(3)), below(2) == 1}; }
  GpsFix fix(Time stamp) { return {stamp, real(), real(), real(), real()}; }
  OperatorCommand command(Time stamp) {
    return {stamp, static_cast<CommandKind>(below(8)), real(), real(), word()};
  }
  SourceReport report(Time stamp) {
    return {stamp, static_cast<Source>(below(5)), static_cast<SourceState>(below(5)), word(),
            static_cast<int>(below(200))};
  }

  TickInput tick(std::uint64_t index, FramePool& pool) {
    TickInput tick;
    tick.index = index;
    tick.now = Time{static_cast<std::int64_t>(index) * 100'000'000 + 7};
    tick.utime_us = 1'700'000'000'000'000 + static_cast<std::int64_t>(index) * 10'000;
    if (below(4) != 0) {
      tick.frame = pool.take();
      fill(tick.frame.writable(), tick.now - Time{1000});
    }
    for (std::uint32_t n = below(4); n > 0; --n) tick.can.push_back(can(tick.now - Time{n}));
    for (std::uint32_t n = below(3); n > 0; --n) tick.edges.push_back(edge(tick.now - Time{n}));
    for (std::uint32_t n = below(2); n > 0; --n) tick.fixes.push_back(fix(tick.now - Time{n}));
    for (std::uint32_t n = below(2); n > 0; --n) tick.commands.push_back(command(tick.now - Time{n}));
    for (std::uint32_t n = below(3); n > 0; --n) tick.reports.push_back(report(tick.now - Time{n}));
    tick.reflex = {tick.now,
                   static_cast<float>(real()),
                   static_cast<float>(real()),
                   static_cast<std::uint8_t>(word()),
                   word(),
                   word()};
    tick.timing = {Time{word()}, Time{word()}, word(), word()};
    return tick;
  }

 private:
  std::mt19937 engine_;
};

/// Bit for bit, as the log's own encoding tells it.
inline std::string fingerprint(const TickInput& tick) {
  std::string text;
  const auto add = [&text](auto value) { text.append(reinterpret_cast<const char*>(&value), sizeof value); };
  add(tick.index), add(tick.now), add(tick.utime_us), add(static_cast<bool>(tick.frame));
  if (tick.frame) {
    const Frame& f = *tick.frame;
    add(f.stamp), add(f.sequence), add(f.format), add(f.width_px), add(f.height_px), add(f.exposure_s),
        add(f.gain);
    text.append(f.bytes.begin(), f.bytes.end());
  }
  for (const auto& s : tick.can) add(s.stamp), add(s.id), add(s.length), add(s.data);
  for (const auto& s : tick.edges) add(s.stamp), add(s.line), add(s.active);
  for (const auto& s : tick.fixes)
    add(s.stamp), add(s.latitude_deg), add(s.longitude_deg), add(s.altitude_m), add(s.horizontal_sigma_m);
  for (const auto& s : tick.commands) add(s.stamp), add(s.kind), add(s.a), add(s.b), add(s.sequence);
  for (const auto& s : tick.reports)
    add(s.stamp), add(s.source), add(s.state), add(s.dropped), add(s.error_code);
  const auto& r = tick.reflex;
  add(r.stamp), add(r.left_mps), add(r.right_mps), add(r.stop_reason), add(r.frames_sent), add(r.send_errors);
  const auto& t = tick.timing;
  add(t.wake_latency), add(t.step_duration), add(t.overruns), add(t.recorder_dropped);
  return text;
}

struct TestRun {
  RunHeader header{1'600'000'000'000'000, true,     "test build", "[loop]\nrate_hz = 10.0\n", "VERSION \"\"",
                   "image_width: 4",      {1, 2, 3}};
  std::vector<TickInput> ticks;
  std::vector<std::vector<PublishedEvent>> published;
};

/// Ticks 0 to count - 1, without those of `lost`.
inline TestRun random_run(std::uint32_t seed, std::uint64_t count, FramePool& pool,
                          const std::vector<std::uint64_t>& lost = {}) {
  RandomSamples random(seed);
  TestRun run;
  for (std::uint64_t index = 0; index < count; ++index) {
    if (std::find(lost.begin(), lost.end(), index) != lost.end()) continue;
    run.ticks.push_back(random.tick(index, pool));
    std::vector<PublishedEvent> published;
    for (std::uint32_t n = random.below(3); n > 0; --n) {
      published.push_back({"HINDSIGHT_POSE_" + std::to_string(n), run.ticks.back().utime_us + n,
                           Bytes(random.below(40), static_cast<std::uint8_t>(random.word()))});
    }
    run.published.push_back(published);
  }
  return run;
}

inline void write_run(const std::filesystem::path& path, const TestRun& run) {
  RunLogWriter writer(path);
  writer.write_header(run.header);
  for (std::size_t i = 0; i < run.ticks.size(); ++i) {
    writer.write_tick(run.ticks[i]);
    for (const auto& event : run.published[i])
      writer.write_published(event.channel, event.utime_us, event.bytes);
    writer.flush();
  }
  ASSERT_TRUE(writer.close());
}

}  // namespace hindsight::test
