// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/sample_faults.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "config/exit_code.h"

namespace hindsight {
namespace {

using std::chrono::milliseconds;

constexpr int kTicks = 60;
constexpr int kBegins = 20, kEnds = 40;  // ticks of the fault, at ten a second

/// Ten ticks a second with a picture, two messages, an edge and, once a second, a fix.
std::vector<TickInput> calm_run(FramePool& pool) {
  std::vector<TickInput> ticks(kTicks);
  for (int i = 0; i < kTicks; ++i) {
    TickInput& tick = ticks[static_cast<std::size_t>(i)];
    const auto n = static_cast<std::uint8_t>(i);
    tick.index = static_cast<std::uint64_t>(i);
    tick.now = milliseconds(5000 + 100 * i);
    tick.frame = pool.take();
    Frame& frame = tick.frame.writable();
    frame.stamp = tick.now;
    frame.sequence = n;
    frame.width_px = 2, frame.height_px = 2;
    frame.bgr = {n, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
    for (const std::uint32_t id : {0x100U, 0x200U})
      tick.can.push_back({tick.now, id, 8, {n, static_cast<std::uint8_t>(id >> 8U)}});
    tick.edges.push_back({tick.now, Line::bumper_left, i % 2 == 0});
    if (i % 10 == 0) tick.fixes.push_back({tick.now, 45.0 + i * 1e-6, 8.0, 0.0, 2.0});
  }
  return ticks;
}

struct SampleFaultsTest : testing::Test {
  FramePool pool{kTicks, 0, 0};
  std::optional<SampleFaults> faults;  // before the ticks that hold its pictures
  std::vector<TickInput> before = calm_run(pool), after;

  void run(const std::string& fault) {
    after = before;
    faults.emplace(std::vector{parse_fault(fault)});
    for (TickInput& tick : after) faults->inject(tick);
  }
  static bool during(int i) { return i >= kBegins && i < kEnds; }
  const TickInput& tick(int i) const { return after[static_cast<std::size_t>(i)]; }
};

TEST(ParseFault, ReadsSourceWordBeginAndLength) {
  const FaultSpec fault = parse_fault("camera:stuck:12.5s:2s");
  EXPECT_EQ(fault.source, Source::camera);
  EXPECT_EQ(fault.kind, FaultKind::stuck);
  EXPECT_EQ(fault.begin, milliseconds(12500));
  EXPECT_EQ(fault.length, milliseconds(2000));
}

TEST(ParseFault, SaysWhatIsWrongAndWhatIsKnown) {
  const std::pair<const char*, const char*> rows[] = {
      {"camera", "four"},           {"camer:off:1s:1s", "camera, can, gpio, gps"},
      {"gps:lost:1s:1s", "stuck"},  {"gps:off:soon:1s", "soon"},
      {"gps:off:-1s:1s", "-1"},     {"gps:off:1s:nan", "nan"},
      {"gps:off:1s:1e300s", "1e3"}, {"", "four"}};
  for (const auto& [text, expected] : rows) {
    try {
      parse_fault(text);
      ADD_FAILURE() << text;
    } catch (const FatalError& error) {
      EXPECT_EQ(error.code(), kExitUsage);
      EXPECT_NE(std::string(error.what()).find(expected), std::string::npos) << error.what();
    }
  }
}

TEST_F(SampleFaultsTest, OffKeepsASourcesSamplesWhileItLasts) {
  for (const char* source : {"camera", "can", "gps"}) {
    run(std::string(source) + ":off:2s:2s");
    for (int i = 0; i < kTicks; ++i) {
      const TickInput& was = before[static_cast<std::size_t>(i)];
      const std::string name = source;
      EXPECT_EQ(bool(tick(i).frame), !(name == "camera" && during(i)));
      EXPECT_EQ(tick(i).can.size(), name == "can" && during(i) ? 0U : was.can.size());
      EXPECT_EQ(tick(i).fixes.size(), name == "gps" && during(i) ? 0U : was.fixes.size());
      EXPECT_EQ(tick(i).edges.size(), was.edges.size());
    }
  }
}

TEST_F(SampleFaultsTest, AChipThatIsOffReportsThatAndItsReturn) {
  run("gpio:off:2s:2s");
  std::vector<SourceState> states;
  for (const TickInput& tick : after) {
    for (const SourceReport& report : tick.reports) states.push_back(report.state);
  }
  EXPECT_EQ(states, (std::vector{SourceState::failed, SourceState::fresh}));
  EXPECT_TRUE(tick(kBegins).edges.empty());
}

TEST_F(SampleFaultsTest, AChipThatIsOffTwiceAtOnceFailsOnce) {
  after = before;
  faults.emplace(std::vector{parse_fault("gpio:off:2s:2s"), parse_fault("gpio:off:3s:2s")});
  std::vector<int> told;
  for (TickInput& tick : after) {
    faults->inject(tick);
    for (std::size_t i = 0; i < tick.reports.size(); ++i) told.push_back(static_cast<int>(tick.index));
  }
  EXPECT_EQ(told, (std::vector{20, 50}));
}

TEST_F(SampleFaultsTest, LinesAreSetRightWhenAFaultOfTheirsEnds) {
  for (std::size_t i = 0; i < before.size(); ++i) before[i].edges.clear();
  before[10].edges.push_back({before[10].now, Line::estop, true});
  before[30].edges.push_back({before[30].now, Line::bumper_left, true});
  for (const char* word : {"off", "stuck", "garbage", "wrong", "slow", "delayed", "intermittent"}) {
    run(std::string("gpio:") + word + ":2s:2s");
    std::array<bool, kLineCount> levels{};
    for (int i = 0; i < kEnds + 6; ++i) {
      for (const LineEdge& edge : tick(i).edges) levels[static_cast<std::size_t>(edge.line)] = edge.active;
    }
    EXPECT_EQ(levels, (std::array{true, false, true})) << word;
  }
}

TEST_F(SampleFaultsTest, StuckRepeatsWhatWasLastSaid) {
  run("camera:stuck:2s:2s");
  for (int i = 0; i < kTicks; ++i) {
    EXPECT_EQ(tick(i).frame->bgr[0], during(i) ? kBegins - 1 : i);
    EXPECT_EQ(tick(i).frame->stamp, tick(i).now) << "it looks alive";
  }
  run("can:stuck:2s:2s");
  for (int i = 0; i < kTicks; ++i) {
    for (const CanFrame& frame : tick(i).can) {
      EXPECT_EQ(frame.data[0], during(i) ? kBegins - 1 : i);
      EXPECT_EQ(frame.data[1], frame.id >> 8U) << "each message its own";
    }
  }
  run("gps:stuck:2s:2s");
  EXPECT_DOUBLE_EQ(tick(30).fixes[0].latitude_deg, before[10].fixes[0].latitude_deg);
  EXPECT_DOUBLE_EQ(tick(40).fixes[0].latitude_deg, before[40].fixes[0].latitude_deg);
}

TEST_F(SampleFaultsTest, GarbageFromTheCameraIsDroppedAndCounted) {
  run("camera:garbage:2s:2s");
  std::uint32_t dropped = 0;
  for (int i = 0; i < kTicks; ++i) {
    EXPECT_EQ(bool(tick(i).frame), !during(i));
    for (const SourceReport& report : tick(i).reports) dropped = report.dropped;
  }
  EXPECT_EQ(dropped, 20U);
}

TEST_F(SampleFaultsTest, GarbageAndWrongChangeWhatIsSaidAndNothingElse) {
  run("can:garbage:2s:2s");
  int changed = 0;
  for (int i = 0; i < kTicks; ++i) {
    for (std::size_t k = 0; k < 2; ++k)
      changed += tick(i).can[k].data != before[static_cast<std::size_t>(i)].can[k].data;
  }
  EXPECT_EQ(changed, 40);
  run("can:wrong:2s:2s");
  EXPECT_EQ(tick(30).can[0].data[1], 2) << "the other message's data";
  EXPECT_EQ(tick(50).can[0].data[1], 1);
  run("camera:wrong:2s:2s");
  EXPECT_EQ(tick(30).frame->bgr[0], 9) << "the last pixel comes first";
  EXPECT_EQ(tick(30).frame->bgr[9], 30);
  EXPECT_EQ(before[30].frame->bgr[0], 30) << "the shared picture itself is left alone";
  run("gpio:wrong:2s:2s");
  EXPECT_EQ(tick(30).edges[0].active, !before[30].edges[0].active);
  run("gps:wrong:2s:2s");
  EXPECT_NEAR((tick(30).fixes[0].latitude_deg - before[30].fixes[0].latitude_deg) * 111195.0, 100.0, 0.1);
}

TEST_F(SampleFaultsTest, SlowLetsEveryFifthPass) {
  run("camera:slow:2s:2s");
  int frames = 0;
  for (int i = kBegins; i < kEnds; ++i) frames += bool(tick(i).frame);
  EXPECT_EQ(frames, 4);
}

TEST_F(SampleFaultsTest, DelayedLosesNothingAndComesHalfASecondLate) {
  run("can:delayed:2s:2s");
  std::size_t frames = 0;
  for (int i = 0; i < kTicks; ++i) {
    for (const CanFrame& frame : tick(i).can) {
      EXPECT_LE(frame.stamp, tick(i).now);
      ++frames;
    }
    EXPECT_EQ(tick(i).can.empty(), i >= kBegins && i < kBegins + 5) << i;
  }
  EXPECT_EQ(frames, std::size_t{2 * kTicks});
  EXPECT_EQ(tick(30).can[0].data[0], 25);
  run("camera:delayed:2s:2s");
  EXPECT_EQ(tick(30).frame->bgr[0], 25);
  EXPECT_EQ(tick(30).frame->stamp, tick(30).now);
}

TEST_F(SampleFaultsTest, IntermittentIsOffAndOnForHalfASecondEach) {
  run("camera:intermittent:2s:2s");
  for (int i = 0; i < kTicks; ++i)
    EXPECT_EQ(bool(tick(i).frame), !during(i) || (i - kBegins) / 5 % 2 == 1) << i;
}

}  // namespace
}  // namespace hindsight
