// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include <limits>
#include <algorithm>
#include <map>

#include "tests/unit/sim_replay/log_test_support.h"

namespace hindsight {
namespace {

using namespace test;

constexpr Time kPeriod = std::chrono::milliseconds(100);

/// Samples of all kinds, each told by its stamp, which no other has.
struct Recording {
  std::vector<Time> frames;
  std::vector<Time> others;
};

Recording write_recording(const std::filesystem::path& path, std::uint32_t seed, bool with_header) {
  RandomSamples random(seed);
  RunLogWriter writer(path);
  if (with_header) writer.write_header({1'000'000, false, "test", "", "", "image_width: 4", {}});
  Recording recording;
  Time stamp = std::chrono::seconds(1);
  for (int i = 0; i < 400; ++i) {
    // Now and then silence for longer than a tick.
    stamp += Time{1 + random.below(random.below(20) == 0 ? 900'000'000 : 30'000'000)};
    const std::int64_t utime_us = stamp.count() / 1000;
    const std::uint32_t kind = random.below(5);
    (kind == 0 ? recording.frames : recording.others).push_back(stamp);
    if (kind == 0) {
      Frame frame;
      random.fill(frame, stamp);
      writer.write_frame(frame, utime_us);
    }
    if (kind == 1) {
      const std::vector<CanFrame> frames{random.can(stamp), random.can(stamp + Time{7}),
                                         random.can(stamp + 2 * kPeriod)};
      recording.others.insert(recording.others.end(), {stamp + Time{7}, stamp + 2 * kPeriod});
      writer.write_can(frames, utime_us);
    }
    if (kind == 2) writer.write_edge(random.edge(stamp), utime_us);
    if (kind == 3) writer.write_fix(random.fix(stamp), utime_us);
    if (kind == 4) writer.write_command(random.command(stamp), utime_us);
  }
  EXPECT_TRUE(writer.close());
  return recording;
}

std::vector<Time> stamps_of(const TickInput& tick) {
  std::vector<Time> stamps;
  for (const auto& s : tick.can) stamps.push_back(s.stamp);
  for (const auto& s : tick.edges) stamps.push_back(s.stamp);
  for (const auto& s : tick.fixes) stamps.push_back(s.stamp);
  for (const auto& s : tick.commands) stamps.push_back(s.stamp);
  return stamps;
}

class SynthesisedTicksOf : public testing::TestWithParam<bool> {};

TEST_P(SynthesisedTicksOf, ARecordingLoseAndDoubleNoSample) {
  const TempFolder folder;
  const Recording recording = write_recording(folder / "run.lcm", 21, GetParam());
  FramePool pool(3, 64, 8);
  ReplaySource source(folder / "run.lcm", pool, decode_bgr24, {false, kPeriod});
  EXPECT_FALSE(source.recorded_ticks());
  EXPECT_EQ(source.header().has_value(), GetParam());

  const Time first = std::min(recording.frames.front(), recording.others.front());
  std::vector<Time> seen;
  std::size_t frames = 0;
  TickInput tick;
  Time before = Time::min();
  std::uint64_t index = 0;
  while (source.next(tick)) {
    EXPECT_EQ(tick.index, index);
    EXPECT_EQ(tick.now, first + static_cast<std::int64_t>(index) * kPeriod);
    EXPECT_EQ(tick.utime_us, tick.now.count() / 1000);
    for (const Time stamp : stamps_of(tick)) {
      EXPECT_LE(stamp, tick.now);
      seen.push_back(stamp);
    }
    const auto after_now = std::upper_bound(recording.frames.begin(), recording.frames.end(), tick.now);
    const bool has_new_frame = after_now != recording.frames.begin() && *std::prev(after_now) > before;
    ASSERT_EQ(static_cast<bool>(tick.frame), has_new_frame);
    if (has_new_frame) {
      EXPECT_EQ(tick.frame->stamp, *std::prev(after_now));
    }
    frames += has_new_frame;
    before = tick.now;
    ++index;
  }
  std::vector<Time> expected = recording.others;
  std::sort(expected.begin(), expected.end());
  std::sort(seen.begin(), seen.end());
  EXPECT_EQ(seen, expected);
  EXPECT_EQ(frames + source.losses().superseded_frames, recording.frames.size());
  EXPECT_GT(source.losses().superseded_frames, 0U);
}

INSTANTIATE_TEST_SUITE_P(WithAndWithoutHeader, SynthesisedTicksOf, testing::Bool());

TEST(SynthesisedTicks, RefuseAStampThatIsHoursAway) {
  const TempFolder folder;
  {
    RunLogWriter writer(folder / "run.lcm");
    writer.write_edge({std::chrono::seconds(1), Line::estop, false}, 1);
    writer.write_edge({std::chrono::hours(2), Line::estop, true}, 2);
    writer.write_edge({std::chrono::seconds(2), Line::estop, false}, 3);
    ASSERT_TRUE(writer.close());
  }
  FramePool pool(3, 64, 8);
  TickInput tick;
  const std::string message = fatal_message(kExitBadData, [&] {
    ReplaySource source(folder / "run.lcm", pool, decode_bgr24, {false, kPeriod});
    while (source.next(tick)) continue;
  });
  EXPECT_NE(message.find("a sample's stamp is out of order"), std::string::npos) << message;
  ReplaySource source(folder / "run.lcm", pool, decode_bgr24, {true, kPeriod});
  std::vector<Time> seen;
  while (source.next(tick)) {
    for (const Time stamp : stamps_of(tick)) seen.push_back(stamp);
  }
  EXPECT_EQ(seen, (std::vector<Time>{std::chrono::seconds(1), std::chrono::seconds(2)}));
}

TEST(SynthesisedTicks, RefuseAnEventOfNoTime) {
  const TempFolder folder;
  {
    RunLogWriter writer(folder / "run.lcm");
    writer.write_edge({std::chrono::seconds(1), Line::estop, false}, std::numeric_limits<std::int64_t>::min() + 3);
    writer.write_edge({std::chrono::seconds(2), Line::estop, true}, 2);
    ASSERT_TRUE(writer.close());
  }
  FramePool pool(3, 64, 8);
  TickInput tick;
  const std::string message = fatal_message(kExitBadData, [&] {
    ReplaySource(folder / "run.lcm", pool, decode_bgr24, {false, kPeriod}).next(tick);
  });
  EXPECT_NE(message.find("an event's time is none since 1970"), std::string::npos) << message;
  ReplaySource source(folder / "run.lcm", pool, decode_bgr24, {true, kPeriod});
  ASSERT_TRUE(source.next(tick));
  EXPECT_EQ(tick.now, std::chrono::seconds(2));
}

TEST(SynthesisedTicks, SkipOnlyThePictureThatCannotBeDecoded) {
  const TempFolder folder;
  const Recording recording = write_recording(folder / "run.lcm", 22, true);
  FramePool pool(3, 64, 8);
  const auto decode_none = [](Frame&) { return false; };
  ReplaySource source(folder / "run.lcm", pool, decode_none, {true, kPeriod});
  TickInput tick;
  std::size_t seen = 0;
  while (source.next(tick)) {
    EXPECT_FALSE(tick.frame);
    seen += stamps_of(tick).size();
  }
  EXPECT_EQ(seen, recording.others.size());
  EXPECT_EQ(source.losses().damaged_places + source.losses().superseded_frames, recording.frames.size());
}

}  // namespace
}  // namespace hindsight
