// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/command_codec.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <random>

#include "config/exit_code.h"

namespace hindsight {
namespace {

constexpr std::int64_t kNow_us = 1'700'000'000'000'000;
constexpr std::int64_t kWindow_us = 5'000'000;
const OperatorCommand kGoTo{Time{}, CommandKind::go_to_local, 12.5, -3.25, 0};

CommandKey some_key() {
  CommandKey key{};
  for (std::size_t i = 0; i < key.size(); ++i) key[i] = static_cast<std::uint8_t>(i * 7 + 1);
  return key;
}

TEST(CommandCodec, RoundTripWithAndWithoutKey) {
  for (const std::optional<CommandKey>& key : {std::optional<CommandKey>{}, std::optional(some_key())}) {
    CommandDecoder decoder(key, kWindow_us);
    OperatorCommand received;
    const auto packet = encode_command(kGoTo, kNow_us, key);
    ASSERT_EQ(decoder.decode(packet, Time(42), kNow_us, received), CommandVerdict::accepted);
    EXPECT_EQ(received.kind, kGoTo.kind);
    EXPECT_EQ(received.a, kGoTo.a);
    EXPECT_EQ(received.b, kGoTo.b);
    EXPECT_EQ(received.stamp, Time(42));
  }
}

TEST(CommandCodec, EveryFlippedBitIsRefusedUnderAKey) {
  const auto packet = encode_command(kGoTo, kNow_us, some_key());
  for (std::size_t bit = 32; bit < packet.size() * 8; ++bit) {
    if (bit >= 32 && bit < 64) continue;  // LCM's own sequence number carries no meaning here
    auto damaged = packet;
    damaged[bit / 8] = static_cast<std::uint8_t>(damaged[bit / 8] ^ (1U << (bit % 8)));
    CommandDecoder decoder(some_key(), kWindow_us);
    OperatorCommand received;
    EXPECT_NE(decoder.decode(damaged, Time{}, kNow_us, received), CommandVerdict::accepted) << "bit " << bit;
  }
}

TEST(CommandCodec, EveryTruncationAndExtensionIsRefused) {
  const auto packet = encode_command(kGoTo, kNow_us, std::nullopt);
  CommandDecoder decoder(std::nullopt, kWindow_us);
  OperatorCommand received;
  for (std::size_t size = 0; size < packet.size(); ++size) {
    EXPECT_NE(decoder.decode(std::span(packet).first(size), Time{}, kNow_us, received), CommandVerdict::accepted);
  }
  auto longer = packet;
  longer.push_back(0);
  EXPECT_EQ(decoder.decode(longer, Time{}, kNow_us, received), CommandVerdict::malformed);
}

TEST(CommandCodec, AReplayedOrUntimelyCommandIsRefused) {
  CommandDecoder decoder(std::nullopt, kWindow_us);
  OperatorCommand received;
  const auto packet = encode_command(kGoTo, kNow_us, std::nullopt);
  EXPECT_EQ(decoder.decode(packet, Time{}, kNow_us + kWindow_us + 1, received), CommandVerdict::untimely);
  EXPECT_EQ(decoder.decode(packet, Time{}, kNow_us - kWindow_us - 1, received), CommandVerdict::untimely);
  EXPECT_EQ(decoder.decode(packet, Time{}, kNow_us, received), CommandVerdict::accepted);
  EXPECT_EQ(decoder.decode(packet, Time{}, kNow_us, received), CommandVerdict::replayed);
  const auto older = encode_command(kGoTo, kNow_us - 1, std::nullopt);
  EXPECT_EQ(decoder.decode(older, Time{}, kNow_us, received), CommandVerdict::replayed);
}

TEST(CommandCodec, AStopIsObeyedWhateverItsAge) {
  const OperatorCommand stop;
  ASSERT_EQ(stop.kind, CommandKind::stop);
  CommandDecoder decoder(some_key(), kWindow_us);
  OperatorCommand received;
  for (const std::int64_t off_us : {-3'600'000'000L, 0L, 0L, 3'600'000'000L}) {
    const auto packet = encode_command(stop, kNow_us + off_us, some_key());
    EXPECT_EQ(decoder.decode(packet, Time{}, kNow_us, received), CommandVerdict::accepted);
  }
  auto forged = encode_command(stop, kNow_us, std::nullopt);
  EXPECT_EQ(decoder.decode(forged, Time{}, kNow_us, received), CommandVerdict::wrong_mac);
}

TEST(CommandCodec, AClockSetBackBeginsTheNumbersAnew) {
  CommandDecoder decoder(std::nullopt, kWindow_us);
  OperatorCommand received;
  ASSERT_EQ(decoder.decode(encode_command(kGoTo, kNow_us, std::nullopt), Time{}, kNow_us, received),
            CommandVerdict::accepted);
  const std::int64_t earlier_us = kNow_us - 3'600'000'000L;
  const auto packet = encode_command(kGoTo, earlier_us, std::nullopt);
  EXPECT_EQ(decoder.decode(packet, Time{}, earlier_us, received), CommandVerdict::accepted);
  EXPECT_EQ(decoder.decode(packet, Time{}, earlier_us, received), CommandVerdict::replayed);
}

TEST(CommandCodec, ValuesThatMeanNothingAreRefused) {
  CommandDecoder decoder(std::nullopt, kWindow_us);
  OperatorCommand received;
  OperatorCommand bad = kGoTo;
  bad.a = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(decoder.decode(encode_command(bad, kNow_us, std::nullopt), Time{}, kNow_us, received),
            CommandVerdict::bad_value);
  bad = kGoTo;
  bad.kind = static_cast<CommandKind>(99);
  EXPECT_EQ(decoder.decode(encode_command(bad, kNow_us, std::nullopt), Time{}, kNow_us, received),
            CommandVerdict::bad_value);
}

TEST(CommandCodec, AnUnsignedOrForeignCommandIsRefusedUnderAKey) {
  CommandDecoder decoder(some_key(), kWindow_us);
  OperatorCommand received;
  EXPECT_EQ(decoder.decode(encode_command(kGoTo, kNow_us, std::nullopt), Time{}, kNow_us, received),
            CommandVerdict::wrong_mac);
  CommandKey other = some_key();
  other[31] ^= 1;
  EXPECT_EQ(decoder.decode(encode_command(kGoTo, kNow_us, other), Time{}, kNow_us, received),
            CommandVerdict::wrong_mac);
}

TEST(CommandCodec, OtherChannelsAreRefused) {
  auto packet = encode_command(kGoTo, kNow_us, std::nullopt);
  packet[8] = 'X';
  CommandDecoder decoder(std::nullopt, kWindow_us);
  OperatorCommand received;
  EXPECT_EQ(decoder.decode(packet, Time{}, kNow_us, received), CommandVerdict::wrong_channel);
}

TEST(CommandCodec, RandomBytesNeverPass) {
  std::mt19937 random(99);
  CommandDecoder decoder(some_key(), kWindow_us);
  for (int i = 0; i < 20000; ++i) {
    auto packet = encode_command(kGoTo, kNow_us, some_key());
    const std::size_t kept = random() % packet.size();
    const auto whole = packet;
    for (std::size_t j = kept; j < packet.size(); ++j) packet[j] = static_cast<std::uint8_t>(random());
    if (packet == whole) continue;
    OperatorCommand received;
    ASSERT_NE(decoder.decode(packet, Time{}, kNow_us, received), CommandVerdict::accepted);
  }
}

class KeyFile : public testing::Test {
 protected:
  void write(const std::string& text, mode_t mode) {
    std::ofstream(path_) << text;
    chmod(path_.c_str(), mode);
  }
  void TearDown() override { std::remove(path_.c_str()); }
  std::string message() {
    try {
      read_command_key(path_);
    } catch (const FatalError& error) {
      EXPECT_EQ(error.code(), kExitConfiguration);
      return error.what();
    }
    return "";
  }
  std::string path_ = testing::TempDir() + "hindsight_key_test_" + std::to_string(getpid());
};

TEST_F(KeyFile, IsReadOrRefusedWithAReason) {
  write(std::string(64, 'a') + "\n", 0600);
  EXPECT_EQ(message(), "");
  write(std::string(64, 'a'), 0644);
  EXPECT_EQ(message(), path_ + ": the command key may be read by others (mode 644); set mode 600");
  write(std::string(63, 'a'), 0600);
  EXPECT_EQ(message(), path_ + ": a command key is 64 hexadecimal digits");
  TearDown();
  EXPECT_EQ(message(), path_ + ": cannot read the command key: No such file or directory");
}

}  // namespace
}  // namespace hindsight
