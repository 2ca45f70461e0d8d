// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The run log beside the stock LCM implementation: liblcm's reader and the tools lcm-logger and
// lcm-logplayer.
#include <lcm/lcm.h>

#include <cstdlib>
#include <memory>

#include "sim_replay/run_log_reader.h"
#include "tests/unit/sim_replay/log_test_support.h"

namespace hindsight {
namespace {

using namespace test;

struct PlainEvent {
  std::int64_t number = 0;
  std::int64_t time_us = 0;
  std::string channel;
  Bytes data;
  bool operator==(const PlainEvent&) const = default;
};

std::vector<PlainEvent> read_with_liblcm(const std::filesystem::path& path) {
  std::vector<PlainEvent> events;
  const std::unique_ptr<lcm_eventlog_t, void (*)(lcm_eventlog_t*)> log(lcm_eventlog_create(path.c_str(), "r"),
                                                                       lcm_eventlog_destroy);
  while (lcm_eventlog_event_t* const event = lcm_eventlog_read_next_event(log.get())) {
    const auto* const data = static_cast<const std::uint8_t*>(event->data);
    events.push_back({event->eventnum, event->timestamp, event->channel, Bytes(data, data + event->datalen)});
    lcm_eventlog_free_event(event);
  }
  return events;
}

std::vector<PlainEvent> read_with_ours(const std::filesystem::path& path) {
  std::vector<PlainEvent> events;
  RunLogReader reader(path);
  for (auto result = reader.next(); result != RunLogReader::Result::end; result = reader.next()) {
    EXPECT_EQ(result, RunLogReader::Result::event)
        << reader.damage().offset << ": " << reader.damage().reason;
    const LogEvent& event = reader.event();
    events.push_back({event.number, event.time_us, std::string(event.channel),
                      Bytes(event.data.begin(), event.data.end())});
  }
  return events;
}

TEST(StockLcm, ReadsOurLogEventForEvent) {
  const TempFolder folder;
  FramePool pool(40, 64, 8);
  write_run(folder / "run.lcm", random_run(31, 30, pool));
  const auto events = read_with_ours(folder / "run.lcm");
  EXPECT_GT(events.size(), 100U);
  EXPECT_EQ(read_with_liblcm(folder / "run.lcm"), events);
}

TEST(StockLcm, WroteLogsThatWeReadEventForEvent) {
  const char* const data = std::getenv("HINDSIGHT_DATA");
  if (data == nullptr) GTEST_SKIP() << "no data";
  for (const char* const name : {"flat.log", "gokart_pos.log", "gokart_rimo.log"}) {
    SCOPED_TRACE(name);
    const auto path = std::filesystem::path(data) / "logs/lcm" / name;
    const auto events = read_with_ours(path);
    EXPECT_GT(events.size(), 10U);
    EXPECT_EQ(events, read_with_liblcm(path));
  }
}

/// lcm-logplayer plays a run log into a network of its own, where lcm-logger records it anew.
TEST(StockLcm, ToolsPlayAndRecordARunLog) {
  const std::string network = "unshare -rn sh -c 'ip link set lo up && ip route add 224.0.0.0/4 dev lo && ";
  if (std::system((network + "command -v lcm-logger lcm-logplayer' > /dev/null 2>&1").c_str()) != 0) {
    GTEST_SKIP() << "no LCM tools, or no network namespace allowed here";
  }
  const TempFolder folder;
  FramePool pool(20, 64, 8);
  TestRun run = random_run(32, 20, pool);
  run.header.utime_us = run.ticks[0].utime_us;
  write_run(folder / "run.lcm", run);
  const std::string played = (folder / "run.lcm").string();
  const std::string recorded = (folder / "recorded.lcm").string();
  const std::string play_and_record = "lcm-logger -q " + recorded +
                                      " & logger=$!; sleep 0.5; lcm-logplayer " + played +
                                      "; sleep 0.5; kill -INT $logger; wait $logger'";
  ASSERT_EQ(std::system((network + play_and_record + " > /dev/null 2>&1").c_str()), 0);
  auto expected = read_with_ours(played);
  auto actual = read_with_ours(recorded);
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(actual[i].channel, expected[i].channel) << i;
    EXPECT_EQ(actual[i].data, expected[i].data) << i;
  }
  // The recording of the playback is a run log like the first.
  ReplaySource source(recorded, pool, decode_bgr24);
  TickInput tick;
  for (const TickInput& original : run.ticks) {
    ASSERT_TRUE(source.next(tick));
    EXPECT_EQ(fingerprint(tick), fingerprint(original));
  }
}

}  // namespace
}  // namespace hindsight
