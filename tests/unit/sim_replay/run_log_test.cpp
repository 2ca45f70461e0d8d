// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include <sys/resource.h>

#include <cerrno>
#include <csignal>
#include <limits>

#include "sim_replay/log_channels.h"
#include "sim_replay/log_messages.h"
#include "sim_replay/run_log_reader.h"
#include "tests/unit/sim_replay/log_test_support.h"

namespace hindsight {
namespace {

using namespace test;

TEST(RunLog, GivesBackRandomTicksBitForBit) {
  const TempFolder folder;
  FramePool pool(300, 64, 8);
  const TestRun run = random_run(20260101, 200, pool);
  write_run(folder / "run.lcm", run);

  ReplaySource source(folder / "run.lcm", pool, decode_bgr24);
  ASSERT_TRUE(source.header());
  EXPECT_TRUE(source.recorded_ticks());
  EXPECT_EQ(source.header()->utime_us, run.header.utime_us);
  EXPECT_EQ(source.header()->build_id, run.header.build_id);
  EXPECT_EQ(source.header()->configuration, run.header.configuration);
  EXPECT_EQ(source.header()->dbc, run.header.dbc);
  EXPECT_EQ(source.header()->calibration, run.header.calibration);
  EXPECT_EQ(source.header()->mixture, run.header.mixture);
  TickInput tick;
  std::vector<PublishedEvent> published;
  for (std::size_t i = 0; i < run.ticks.size(); ++i) {
    ASSERT_TRUE(source.next(tick, &published)) << i;
    EXPECT_EQ(fingerprint(tick), fingerprint(run.ticks[i])) << i;
    if (tick.frame) {
      EXPECT_EQ(tick.frame->bgr, tick.frame->bytes);
    }
    ASSERT_EQ(published.size(), run.published[i].size()) << i;
    for (std::size_t k = 0; k < published.size(); ++k) {
      EXPECT_EQ(published[k].channel, run.published[i][k].channel);
      EXPECT_EQ(published[k].utime_us, run.published[i][k].utime_us);
      EXPECT_EQ(published[k].bytes, run.published[i][k].bytes);
    }
  }
  EXPECT_FALSE(source.next(tick, &published));
  EXPECT_EQ(source.progress(), 1.0);
}

TEST(RunLog, GivesTheSameTicksToWhomThePublishedMessagesDoNotConcern) {
  const TempFolder folder;
  FramePool pool(40, 64, 8);
  const TestRun run = random_run(2, 20, pool);
  write_run(folder / "run.lcm", run);
  ReplaySource source(folder / "run.lcm", pool, decode_bgr24);
  TickInput tick;
  for (const TickInput& expected : run.ticks) {
    ASSERT_TRUE(source.next(tick));
    EXPECT_EQ(fingerprint(tick), fingerprint(expected));
  }
  EXPECT_FALSE(source.next(tick));
}

TEST(RunLog, ReadAndWrittenAgainHasTheSameBytes) {
  const TempFolder folder;
  FramePool pool(60, 64, 8);
  write_run(folder / "run.lcm", random_run(3, 40, pool, {0, 5, 6, 20}));

  ReplaySource source(folder / "run.lcm", pool, decode_bgr24);
  RunLogWriter writer(folder / "again.lcm");
  writer.write_header(*source.header());
  TickInput tick;
  std::vector<PublishedEvent> published;
  while (source.next(tick, &published)) {
    writer.write_tick(tick);
    for (const auto& event : published) writer.write_published(event.channel, event.utime_us, event.bytes);
  }
  ASSERT_TRUE(writer.close());
  EXPECT_EQ(read_bytes(folder / "again.lcm"), read_bytes(folder / "run.lcm"));
}

TEST(RunLog, TellsOfTicksThatWereNeverRecorded) {
  const TempFolder folder;
  FramePool pool(60, 64, 8);
  write_run(folder / "run.lcm", random_run(4, 40, pool, {0, 5, 6, 20}));
  ReplaySource source(folder / "run.lcm", pool, decode_bgr24);
  TickInput tick;
  int ticks = 0;
  while (source.next(tick)) ++ticks;
  EXPECT_EQ(ticks, 36);
  EXPECT_EQ(source.losses().unrecorded_ticks, 4U);
  EXPECT_EQ(source.losses().incomplete_ticks, 0U);
}

TEST(RunLog, StampsTheHeaderAndEachTickWithUnixTime) {
  const TempFolder folder;
  FramePool pool(10, 64, 8);
  const TestRun run = random_run(5, 2, pool);
  write_run(folder / "run.lcm", run);
  RunLogReader reader(folder / "run.lcm");
  ASSERT_EQ(reader.next(), RunLogReader::Result::event);
  EXPECT_EQ(reader.event().channel, log_channel::kHeader);
  EXPECT_EQ(reader.event().time_us, run.header.utime_us);
  std::int64_t number = 0;
  EXPECT_EQ(reader.event().number, number);
  while (reader.next() == RunLogReader::Result::event) {
    EXPECT_EQ(reader.event().number, ++number);
    EXPECT_GE(reader.event().time_us, run.ticks[0].utime_us);
  }
}

TEST(RunLog, FullDiskIsAnErrorStateAndNoException) {
  FramePool pool(10, 64, 8);
  const TestRun run = random_run(6, 3, pool);
  RunLogWriter writer("/dev/full");
  EXPECT_TRUE(writer.write_header(run.header));
  EXPECT_TRUE(writer.write_tick(run.ticks[0]));
  EXPECT_FALSE(writer.flush());
  EXPECT_FALSE(writer.ok());
  EXPECT_EQ(writer.error_code(), ENOSPC);
  EXPECT_FALSE(writer.write_tick(run.ticks[1]));
  EXPECT_FALSE(writer.write_published("POSE", 0, Bytes(3)));
  EXPECT_FALSE(writer.close());
  EXPECT_EQ(writer.bytes_written(), 0U);
}

/// A limit on the file's size fails in the middle of a write, as a full disk does.
TEST(RunLog, FullDiskLeavesALogOfWholeTicks) {
  const TempFolder folder;
  FramePool pool(100, 64, 8);
  const TestRun run = random_run(7, 60, pool);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{10'000, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  RunLogWriter writer(folder / "run.lcm");
  writer.write_header(run.header);
  std::size_t written = 0;
  while (written < run.ticks.size() && writer.write_tick(run.ticks[written]) && writer.flush()) ++written;
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);

  EXPECT_EQ(writer.error_code(), EFBIG);
  ASSERT_GT(written, 2U);
  ASSERT_LT(written, run.ticks.size());
  EXPECT_EQ(std::filesystem::file_size(folder / "run.lcm"), writer.bytes_written());
  ReplaySource source(folder / "run.lcm", pool, decode_bgr24);
  TickInput tick;
  for (std::size_t i = 0; i < written; ++i) ASSERT_TRUE(source.next(tick)) << i;
  EXPECT_FALSE(source.next(tick));
}

TEST(RunLog, CannotBeCreatedWhereThereIsNoFolder) {
  const std::string message = fatal_message(kExitIo, [] { RunLogWriter("/nowhere/at/all/run.lcm"); });
  EXPECT_NE(message.find("/nowhere/at/all/run.lcm: cannot create the log"), std::string::npos) << message;
}

TEST(RunLog, RefusesChannelsThatNoReaderTakes) {
  const TempFolder folder;
  RunLogWriter writer(folder / "run.lcm");
  EXPECT_FALSE(writer.write_published(std::string(1000, 'x'), 0, {}));
  EXPECT_EQ(writer.error_code(), EMSGSIZE);
}

/// The checked decoding reads counts where kDeclaredArrays says: every element more must add its bytes.
template <class Message>
void expect_counts_at(const Message& message, const std::vector<std::int32_t>& counts) {
  Bytes bytes(static_cast<std::size_t>(message.getEncodedSize()));
  encode_sealed(message, bytes);
  std::size_t size = static_cast<std::size_t>(Message{}.getEncodedSize());
  ASSERT_EQ(counts.size(), kDeclaredArrays<Message>.size());
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const DeclaredArray array = kDeclaredArrays<Message>[i];
    EXPECT_EQ(read_big_endian<std::int32_t>(bytes.data() + array.count_at), counts[i]) << i;
    size += array.element_bytes * static_cast<std::size_t>(counts[i]);
  }
  EXPECT_EQ(bytes.size(), size);
  Message decoded{};
  EXPECT_EQ(decode_sealed(bytes, decoded), nullptr);
}

TEST(LogMessages, DeclareTheirCountsWhereTheyAreLookedFor) {
  Frame frame;
  frame.bytes.resize(77);
  raw_frame_t frame_message{};
  to_message(frame, frame_message);
  expect_counts_at(frame_message, {77});
  raw_can_t can_message{};
  to_message(std::vector<CanFrame>(5), can_message);
  expect_counts_at(can_message, {5});
  expect_counts_at(to_message(RunHeader{0, true, "a", "bc", "def", "ghij", {5, 6, 7, 8, 9}}),
                   {1, 2, 3, 4, 5});
}

/// A checksum that is right does not make a count right.
TEST(LogMessages, RefuseCountsThatTheBytesDoNotHold) {
  for (const std::uint32_t count : {0x7FFFFFFFU, 0xFFFFFFFFU, 0x80000000U, 4U, 6U}) {
    raw_can_t message{};
    to_message(std::vector<CanFrame>(5), message);
    Bytes bytes(static_cast<std::size_t>(message.getEncodedSize()));
    encode_sealed(message, bytes);
    write_big_endian(count, bytes.data() + kDeclaredArrays<raw_can_t>[0].count_at);
    const std::size_t body = bytes.size() - kCrcBytes;
    write_big_endian(crc32(std::span(bytes).first(body)), bytes.data() + body);
    raw_can_t decoded{};
    EXPECT_STREQ(decode_sealed(bytes, decoded), "a sample's size is not what it declares") << count;
  }
}

TEST(LogMessages, RefuseValuesThatASampleCannotHave) {
  Frame frame;
  raw_frame_t message{};
  to_message(frame, message);
  EXPECT_FALSE(from_message(message, frame));  // 0 x 0 pixels
  message.width_px = message.height_px = 16385;
  EXPECT_FALSE(from_message(message, frame));
  message.width_px = message.height_px = 2;
  EXPECT_TRUE(from_message(message, frame));
  message.format = 3;
  EXPECT_FALSE(from_message(message, frame));
  LineEdge edge;
  EXPECT_FALSE(from_message(raw_line_t{0, 3, 1, 0}, edge));
  OperatorCommand command;
  EXPECT_FALSE(from_message(raw_command_t{0, 8, 0.0, 0.0, 0, 0}, command));
  SourceReport report;
  EXPECT_FALSE(from_message(raw_report_t{0, 5, 0, 0, 0, 0}, report));
  EXPECT_FALSE(from_message(raw_report_t{0, 0, 5, 0, 0, 0}, report));
  raw_can_t can{};
  to_message(std::vector<CanFrame>{{Time{}, 1, 9, {}}}, can);
  std::vector<CanFrame> frames;
  EXPECT_FALSE(from_message(can, frames));
  EXPECT_TRUE(frames.empty());
  EXPECT_FALSE(from_message(raw_line_t{std::numeric_limits<std::int64_t>::min(), 0, 1, 0}, edge));
  EXPECT_TRUE(is_stamp(-7));
}

}  // namespace
}  // namespace hindsight
