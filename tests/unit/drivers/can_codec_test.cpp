// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "drivers/can_codec.h"

#include <gtest/gtest.h>
#include <linux/can.h>

#include <cmath>
#include <random>

#include "expect_fatal.h"

namespace hindsight {
namespace {

DbcSignal signal(int start, int length, bool little_endian, bool is_signed = false, double factor = 1.0,
                 double offset = 0.0) {
  DbcSignal result;
  result.name = "X";
  result.start_bit = start;
  result.length_bits = length;
  result.little_endian = little_endian;
  result.is_signed = is_signed;
  result.factor = factor;
  result.offset = offset;
  return result;
}

TEST(CanCodec, LittleEndianBitsLieWhereTheFormatSays) {
  CanPayload data{};
  insert_bits(data, signal(4, 12, true), 0xABC);
  EXPECT_EQ(data, (CanPayload{0xC0, 0xAB}));
  EXPECT_EQ(extract_bits(data, signal(4, 12, true)), 0xABCU);
}

TEST(CanCodec, BigEndianBitsLieWhereTheFormatSays) {
  CanPayload data{};
  insert_bits(data, signal(3, 12, false), 0xABC);  // most significant bit: bit 3 of byte 0
  EXPECT_EQ(data, (CanPayload{0x0A, 0xBC}));
  EXPECT_EQ(extract_bits(data, signal(3, 12, false)), 0xABCU);
}

TEST(CanCodec, WholePayloadIsOneSignal) {
  CanPayload data{1, 2, 3, 4, 5, 6, 7, 8};
  EXPECT_EQ(extract_bits(data, signal(0, 64, true)), 0x0807060504030201U);
  EXPECT_EQ(extract_bits(data, signal(7, 64, false)), 0x0102030405060708U);
}

TEST(CanCodec, InsertingLeavesOtherBitsAlone) {
  std::mt19937_64 random(20260101);
  for (int i = 0; i < 2000; ++i) {
    const bool little = (random() & 1U) != 0;
    const int length = 1 + static_cast<int>(random() % 20);
    const int first = static_cast<int>(random() % static_cast<unsigned>(64 - length));
    const DbcSignal s = signal(little ? first : first / 8 * 8 + 7 - first % 8, length, little);
    CanPayload data{};
    for (auto& byte : data) byte = static_cast<std::uint8_t>(random());
    const CanPayload before = data;
    const std::uint64_t old_bits = extract_bits(data, s);
    insert_bits(data, s, random());
    insert_bits(data, s, old_bits);
    EXPECT_EQ(data, before);
  }
}

TEST(CanCodec, SignedValuesAndScaling) {
  const DbcSignal s = signal(0, 14, true, true, 0.001);
  CanPayload data{};
  encode_signal(data, s, -1.2344);
  EXPECT_DOUBLE_EQ(decode_signal(data, s), -1.234);
  encode_signal(data, s, 1e9);
  EXPECT_DOUBLE_EQ(decode_signal(data, s), 8.191);
  encode_signal(data, s, -INFINITY);
  EXPECT_DOUBLE_EQ(decode_signal(data, s), -8.192);
}

TEST(CanCodec, DeclaredLimitsHoldTheValue) {
  DbcSignal s = signal(0, 16, true, true, 0.001);
  s.min = -5;
  s.max = 5;
  CanPayload data{};
  encode_signal(data, s, 7.0);
  EXPECT_DOUBLE_EQ(decode_signal(data, s), 5.0);
  EXPECT_TRUE(within_limits(s, 5.0));
  EXPECT_FALSE(within_limits(s, 5.001));
  EXPECT_FALSE(within_limits(s, -5.001));
}

// The published check value: the CRC of "123456789" is 0x4B. The identifier stands for the first four of
// them.
TEST(CanCodec, CrcIsSaeJ1850) { EXPECT_EQ(crc8_j1850(0x34333231, {'5', '6', '7', '8', '9'}, 5), 0x4B); }

class ProtectedMessages : public testing::Test {
 protected:
  const Dbc dbc_ = read_dbc(HINDSIGHT_SOURCE_DIR "/config/lagr.dbc");
};

TEST_F(ProtectedMessages, EveryFlippedBitIsRefused) {
  std::mt19937_64 random(20260102);
  for (const DbcMessage& declared : dbc_.messages) {
    const ProtectedMessage message(dbc_, declared, "COUNTER", "CHECKSUM");
    for (int i = 0; i < 200; ++i) {
      CanFrame frame;
      for (std::size_t byte = 0; byte < static_cast<std::size_t>(declared.length_bytes); ++byte) {
        frame.data[byte] = static_cast<std::uint8_t>(random());
      }
      message.seal(frame, static_cast<std::uint32_t>(i));
      ASSERT_EQ(message.check(frame), FrameFault::none);
      for (int bit = 0; bit < declared.length_bytes * 8; ++bit) {
        CanFrame flipped = frame;
        flipped.data[static_cast<std::size_t>(bit / 8)] ^= static_cast<std::uint8_t>(1U << (bit % 8));
        EXPECT_EQ(message.check(flipped), FrameFault::wrong_checksum) << declared.name << " bit " << bit;
      }
    }
  }
}

TEST_F(ProtectedMessages, AFrameUnderAnotherIdentifierIsRefused) {
  const ProtectedMessage currents(dbc_, *dbc_.find("MOTOR_CURRENTS"), "COUNTER", "CHECKSUM");
  const ProtectedMessage ranges(dbc_, *dbc_.find("IR_RANGES"), "COUNTER", "CHECKSUM");
  CanFrame frame;
  currents.seal(frame, 3);
  EXPECT_EQ(ranges.check(frame), FrameFault::wrong_checksum);
}

TEST_F(ProtectedMessages, AnotherLengthIsRefused) {
  const ProtectedMessage message(dbc_, *dbc_.find("BATTERY"), "COUNTER", "CHECKSUM");
  CanFrame frame;
  message.seal(frame, 0);
  for (std::uint8_t length = 0; length <= 8; ++length) {
    frame.length = length;
    EXPECT_EQ(message.check(frame), length == 4 ? FrameFault::none : FrameFault::wrong_length);
  }
}

TEST_F(ProtectedMessages, CounterWraps) {
  const ProtectedMessage message(dbc_, *dbc_.find("BATTERY"), "COUNTER", "CHECKSUM");
  EXPECT_EQ(message.next_counter(14), 15U);
  EXPECT_EQ(message.next_counter(15), 0U);
  CanFrame frame;
  message.seal(frame, 18);
  EXPECT_EQ(message.counter(frame), 2U);
}

TEST_F(ProtectedMessages, CounterAndChecksumMustBeThere) {
  const DbcMessage& message = *dbc_.find("BATTERY");
  expect_fatal(kExitConfiguration, {"lagr.dbc:", "BATTERY", "counter", "TICK"},
               [&] { ProtectedMessage(dbc_, message, "TICK", "CHECKSUM"); });
  expect_fatal(kExitConfiguration, {"BATTERY", "checksum", "VOLTAGE"},
               [&] { ProtectedMessage(dbc_, message, "COUNTER", "VOLTAGE"); });
}

}  // namespace
}  // namespace hindsight
