// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include <limits>
#include <map>
#include <set>

#include "sim_replay/big_endian.h"
#include "sim_replay/event_log_format.h"
#include "sim_replay/event_log_writer.h"
#include "sim_replay/log_channels.h"
#include "sim_replay/log_messages.h"
#include "sim_replay/run_log_reader.h"
#include "tests/unit/sim_replay/log_test_support.h"

namespace hindsight {
namespace {

using namespace test;

struct EventPlace {
  std::uint64_t begin = 0;
  std::uint64_t end = 0;
  std::string channel;
};

std::vector<EventPlace> places_of(const std::filesystem::path& path) {
  std::vector<EventPlace> places;
  RunLogReader reader(path);
  while (reader.next() == RunLogReader::Result::event) {
    places.push_back({reader.event().offset, reader.position(), std::string(reader.event().channel)});
  }
  return places;
}

/// What a replay gives of a damaged log.
struct Outcome {
  std::vector<std::string> ticks;
  std::string error;
  ReplayLosses losses;
};

class DamagedLog : public testing::Test {
 protected:
  DamagedLog() : run_(random_run(11, 6, pool_)) {
    write_run(folder_ / "whole.lcm", run_);
    whole_ = read_bytes(folder_ / "whole.lcm");
    places_ = places_of(folder_ / "whole.lcm");
    for (const TickInput& tick : run_.ticks) expected_.push_back(fingerprint(tick));
  }

  Outcome replay(const Bytes& log, bool recover) {
    write_bytes(folder_ / "damaged.lcm", log);
    Outcome outcome;
    try {
      ReplaySource source(folder_ / "damaged.lcm", pool_, decode_bgr24, {recover, from_seconds(0.1)});
      TickInput tick;
      std::vector<PublishedEvent> published;
      while (source.next(tick, &published)) outcome.ticks.push_back(fingerprint(tick));
      outcome.losses = source.losses();
    } catch (const FatalError& error) {
      EXPECT_EQ(error.code(), kExitBadData) << error.what();
      outcome.error = error.what();
    }
    return outcome;
  }

  std::size_t whole_ticks_before(std::uint64_t offset) const {
    std::size_t ticks = 0;
    for (const EventPlace& place : places_)
      ticks += place.channel == log_channel::kTick && place.end <= offset;
    return ticks;
  }

  FramePool pool_{64, 64, 8};
  TempFolder folder_;
  TestRun run_;
  Bytes whole_;
  std::vector<EventPlace> places_;
  std::vector<std::string> expected_;
};

/// How a message names a place.
std::string at_byte(std::uint64_t offset) { return ": byte " + std::to_string(offset) + ": "; }

TEST_F(DamagedLog, CutAnywhereNamesWhereAndRecoversWholeTicks) {
  std::set<std::uint64_t> boundaries{whole_.size()};
  for (const EventPlace& place : places_) boundaries.insert(place.begin);
  for (std::size_t cut = 0; cut < whole_.size(); ++cut) {
    SCOPED_TRACE(cut);
    const Bytes log(whole_.begin(), whole_.begin() + static_cast<std::ptrdiff_t>(cut));
    const std::uint64_t event_begin = *std::prev(boundaries.upper_bound(cut));
    const Outcome strict = replay(log, false);
    if (event_begin != cut) {
      // Fewer than four bytes are no LCM event log at all.
      EXPECT_NE(strict.error.find(at_byte(event_begin)), std::string::npos) << strict.error;
    }
    const Outcome recovered = replay(log, true);
    const std::size_t ticks = whole_ticks_before(cut);
    if (cut > places_[1].end) {
      EXPECT_EQ(recovered.error, "");
    }
    ASSERT_EQ(recovered.ticks.size(), ticks);
    EXPECT_TRUE(std::equal(recovered.ticks.begin(), recovered.ticks.end(), expected_.begin()));
  }
}

/// Every tick that comes out, of whichever damaged log, is one that went in, in order.
void expect_only_true_ticks(const Outcome& outcome, const std::vector<std::string>& expected) {
  auto from = expected.begin();
  for (const std::string& tick : outcome.ticks) {
    from = std::find(from, expected.end(), tick);
    ASSERT_NE(from, expected.end()) << "an altered tick passed as valid";
    ++from;
  }
}

TEST_F(DamagedLog, AnyFlippedByteNeitherCrashesNorAltersATick) {
  for (const int mask : {0x01, 0x80, 0xFF}) {
    for (std::size_t at = 0; at < whole_.size(); ++at) {
      SCOPED_TRACE(testing::Message() << "byte " << at << " mask " << mask);
      Bytes log = whole_;
      log[at] = static_cast<std::uint8_t>(log[at] ^ mask);
      const Outcome strict = replay(log, false);
      expect_only_true_ticks(strict, expected_);
      if (strict.error.empty()) {
        EXPECT_EQ(strict.ticks.size(), expected_.size());
      }
      const Outcome recovered = replay(log, true);
      EXPECT_EQ(recovered.error, "");
      expect_only_true_ticks(recovered, expected_);
      // A tick event that is lost takes the next tick with it, whose samples cannot be told from its own.
      EXPECT_GE(recovered.ticks.size() + 2, expected_.size());
      EXPECT_EQ(recovered.ticks.size() + recovered.losses.incomplete_ticks, expected_.size());
    }
  }
}

TEST_F(DamagedLog, RandomBytesInTheMiddleCostOnlyTheTicksThatTheyHit) {
  RandomSamples random(12);
  for (int trial = 0; trial < 200; ++trial) {
    SCOPED_TRACE(trial);
    const std::size_t begin =
        places_[1].begin + random.below(static_cast<std::uint32_t>(whole_.size() - places_[1].begin));
    const std::size_t end = std::min<std::size_t>(whole_.size(), begin + 1 + random.below(200));
    Bytes log = whole_;
    for (std::size_t i = begin; i < end; ++i) log[i] = static_cast<std::uint8_t>(random.word());
    const Outcome recovered = replay(log, true);
    expect_only_true_ticks(recovered, expected_);
    const std::size_t before = whole_ticks_before(begin);
    const std::size_t lost_at_most = whole_ticks_before(end) - before + 2;
    ASSERT_GE(recovered.ticks.size() + lost_at_most, expected_.size());
    EXPECT_TRUE(std::equal(expected_.begin(), expected_.begin() + static_cast<std::ptrdiff_t>(before),
                           recovered.ticks.begin()));
  }
}

/// A length that swallows the next event costs the event that has it, never the next.
TEST_F(DamagedLog, AWrongLengthDoesNotSwallowTheNextEvent) {
  for (std::size_t i = 1; i + 1 < places_.size(); ++i) {
    SCOPED_TRACE(i);
    Bytes log = whole_;
    std::uint8_t* const length = log.data() + places_[i].begin + 24;
    write_big_endian(read_big_endian<std::int32_t>(length) + 5, length);
    write_bytes(folder_ / "damaged.lcm", log);
    RunLogReader reader(folder_ / "damaged.lcm");
    std::set<std::uint64_t> seen;
    std::vector<std::uint64_t> damaged;
    for (auto result = reader.next(); result != RunLogReader::Result::end; result = reader.next()) {
      if (result == RunLogReader::Result::event) seen.insert(reader.event().offset);
      if (result == RunLogReader::Result::damage) damaged.push_back(reader.damage().offset);
    }
    EXPECT_EQ(seen.size(), places_.size() - 1);
    EXPECT_EQ(seen.count(places_[i].begin), 0U);
    EXPECT_EQ(damaged, std::vector{places_[i].begin});
  }
}

TEST_F(DamagedLog, HugeDeclaredLengthsAreRefusedAndNotAllocated) {
  for (const std::uint32_t length : {0x7FFFFFFFU, 0xFFFFFFFFU, 0x80000000U, 0x04000001U, 0x03FFFFFFU}) {
    for (const std::size_t field : {20U, 24U}) {
      Bytes log = whole_;
      write_big_endian(length, log.data() + places_[3].begin + field);
      const Outcome strict = replay(log, false);
      EXPECT_NE(strict.error.find(at_byte(places_[3].begin) + "an event declares"), std::string::npos)
          << strict.error;
    }
  }
}

TEST_F(DamagedLog, ADamagedSampleIsNamedByItsEvent) {
  const auto frame = std::find_if(places_.begin(), places_.end(),
                                  [](const EventPlace& p) { return p.channel == log_channel::kCamera; });
  ASSERT_NE(frame, places_.end());
  Bytes log = whole_;
  log[frame->end - 10] = static_cast<std::uint8_t>(log[frame->end - 10] ^ 0x10);
  const Outcome strict = replay(log, false);
  EXPECT_NE(strict.error.find(at_byte(frame->begin) + "a sample's checksum is wrong"), std::string::npos)
      << strict.error;
  const Outcome recovered = replay(log, true);
  EXPECT_EQ(recovered.ticks.size(), expected_.size() - 1);
  EXPECT_EQ(recovered.losses.damaged_places, 1U);
  EXPECT_EQ(recovered.losses.damage.at(0).offset, frame->begin);
}

/// With a right checksum, as who wants to harm would write it.
TEST_F(DamagedLog, ATickOfNoPossibleNumberIsDamage) {
  const auto tick = std::find_if(places_.begin(), places_.end(),
                                 [](const EventPlace& p) { return p.channel == log_channel::kTick; });
  ASSERT_NE(tick, places_.end());
  Bytes log = whole_;
  const std::size_t data = tick->begin + kEventHeaderBytes + tick->channel.size();
  const std::size_t checksum = tick->end - kCrcBytes;
  write_big_endian(std::numeric_limits<std::int64_t>::max(), &log[data + 8]);  // after the type's hash
  write_big_endian(crc32(std::span(log).subspan(data, checksum - data)), &log[checksum]);
  const Outcome strict = replay(log, false);
  EXPECT_NE(strict.error.find(at_byte(tick->begin) + "a tick holds a value that it cannot have"), std::string::npos)
      << strict.error;
  EXPECT_EQ(replay(log, true).ticks.size(), expected_.size() - 1);
}

TEST_F(DamagedLog, APictureThatCannotBeDecodedIsDamage) {
  write_bytes(folder_ / "damaged.lcm", whole_);
  const auto decode_nothing = [](Frame&) { return false; };
  TickInput tick;
  const std::string message = fatal_message(kExitBadData, [&] {
    ReplaySource source(folder_ / "damaged.lcm", pool_, decode_nothing);
    while (source.next(tick)) continue;
  });
  EXPECT_NE(message.find("a camera frame cannot be decoded"), std::string::npos) << message;
}

class ReaderErrors : public testing::Test {
 protected:
  std::string open_error(ExitCode code, const std::filesystem::path& path, bool recover = false) {
    return fatal_message(code, [&] {
      ReplaySource(path, pool_, decode_bgr24, {recover, from_seconds(0.1)});
    });
  }
  FramePool pool_{4, 64, 8};
  TempFolder folder_;
};

TEST_F(ReaderErrors, NameTheFileAndWhatWasExpected) {
  EXPECT_THAT(open_error(kExitNoInput, folder_ / "absent.lcm"),
              testing::HasSubstr("absent.lcm: cannot open the log"));
  EXPECT_THAT(open_error(kExitNoInput, folder_ / ""), testing::HasSubstr("not a regular file"));
  write_text(folder_ / "empty.lcm", "");
  EXPECT_THAT(open_error(kExitBadData, folder_ / "empty.lcm"),
              testing::HasSubstr("empty.lcm: the file is empty"));
  write_text(folder_ / "text.lcm", "this is not a log");
  EXPECT_THAT(open_error(kExitBadData, folder_ / "text.lcm"),
              testing::HasSubstr("text.lcm: byte 0: not an LCM event log"));
  EXPECT_THAT(open_error(kExitBadData, folder_ / "text.lcm", true),
              testing::HasSubstr("not an LCM event log"));
}

TEST_F(ReaderErrors, TellAStrangersLogFromADamagedOne) {
  EventLogWriter writer(folder_ / "stranger.lcm");
  writer.append("IMU", 1, 8);
  writer.append("GPS", 2, 8);
  ASSERT_TRUE(writer.close());
  const std::string message = open_error(kExitBadData, folder_ / "stranger.lcm");
  EXPECT_THAT(message, testing::HasSubstr("an LCM event log, but not of a Hindsight run"));
  EXPECT_THAT(message, testing::HasSubstr("GPS, IMU"));
}

TEST_F(ReaderErrors, TellARunWithoutSamples) {
  RunLogWriter writer(folder_ / "header.lcm");
  writer.write_header({});
  ASSERT_TRUE(writer.close());
  EXPECT_THAT(open_error(kExitBadData, folder_ / "header.lcm"),
              testing::HasSubstr("a run log without samples"));
}

}  // namespace
}  // namespace hindsight
