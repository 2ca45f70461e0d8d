// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/mixture_codec.h"

#include <gtest/gtest.h>

#include <limits>

#include "config/crc32.h"
#include "perception/saved_bytes.h"

namespace hindsight {
namespace {

MixtureSnapshot sample() {
  MixtureSnapshot mixture{ColorSpace::lab, std::vector<MixtureComponent>(3)};
  for (std::size_t i = 0; i < 3; ++i) {
    MixtureComponent& c = mixture.components[i];
    const double k = static_cast<double>(i) + 1.0;
    c.mean = Eigen::Vector3d(10.5 * k, -3.25, 1.0 / 3.0);
    c.covariance << 9 * k, 1, 0.5, 1, 7, 0.25, 0.5, 0.25, 5;
    c.weight_px = 1000 * k;
    c.votes = {0.5 * k, 0.0, 2.0};
    c.label = static_cast<TerrainClass>(i + 1);
  }
  mixture.texture[0][5] = 0.75;
  mixture.texture[2][63] = 4.0;
  return mixture;
}

TEST(MixtureCodec, GivesBackWhatWentIn) {
  for (const MixtureSnapshot& mixture : {sample(), MixtureSnapshot{}}) {
    const MixtureDecoded decoded = decode_mixture(encode_mixture(mixture));
    EXPECT_EQ(decoded.problem, "");
    EXPECT_EQ(decoded.mixture.color_space, mixture.color_space);
    EXPECT_EQ(decoded.mixture.components, mixture.components);
    EXPECT_EQ(decoded.mixture.texture, mixture.texture);
  }
}

/// As version 1 wrote it.
std::vector<std::uint8_t> without_texture(std::vector<std::uint8_t> bytes) {
  bytes.resize(bytes.size() - sizeof(TextureVotes) - 4);
  bytes[4] = 1;
  put(bytes, crc32(bytes));
  return bytes;
}

TEST(MixtureCodec, ReadsMixturesFromBeforeTexturesWereLearned) {
  const MixtureDecoded decoded = decode_mixture(without_texture(encode_mixture(sample())));
  EXPECT_EQ(decoded.problem, "");
  EXPECT_EQ(decoded.mixture.components, sample().components);
  EXPECT_EQ(decoded.mixture.texture, TextureVotes{});
}

TEST(MixtureCodec, RefusesVotesOfTexturesThatAreNone) {
  MixtureSnapshot mixture = sample();
  mixture.texture[1][2] = -0.5;
  EXPECT_EQ(decode_mixture(encode_mixture(mixture)).problem, "byte 855: no number of votes");
}

TEST(MixtureCodec, RefusesEveryTruncationAndEveryByteTooMany) {
  std::vector<std::uint8_t> bytes = encode_mixture(sample());
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    const MixtureDecoded decoded = decode_mixture(std::span(bytes).first(length));
    EXPECT_NE(decoded.problem, "") << length;
    EXPECT_TRUE(decoded.mixture.components.empty());
  }
  bytes.push_back(0);
  EXPECT_NE(decode_mixture(bytes).problem, "");
}

TEST(MixtureCodec, RefusesEveryFlippedBit) {
  std::vector<std::uint8_t> bytes = encode_mixture(sample());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit) {
      const auto mask = static_cast<std::uint8_t>(1 << bit);
      bytes[i] ^= mask;
      EXPECT_NE(decode_mixture(bytes).problem, "") << i << ":" << bit;
      bytes[i] ^= mask;
    }
  }
}

TEST(MixtureCodec, RefusesNumbersThatNoMixtureHasUnderAGoodChecksum) {
  const auto problem_after = [](auto&& spoil) {
    MixtureSnapshot mixture = sample();
    spoil(mixture.components[1]);
    return decode_mixture(encode_mixture(mixture)).problem;
  };
  const std::string expected = "byte 117: component 1 is no Gaussian with votes";
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                   inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(problem_after([](auto& c) { c.mean[2] = nan; }), expected);
  EXPECT_EQ(problem_after([](auto& c) { c.covariance(0, 1) = c.covariance(1, 0) = inf; }), expected);
  EXPECT_EQ(problem_after([](auto& c) { c.covariance(1, 1) = -1.0; }), expected);
  EXPECT_EQ(problem_after([](auto& c) { c.weight_px = -1.0; }), expected);
  EXPECT_EQ(problem_after([](auto& c) { c.votes[0] = nan; }), expected);
  EXPECT_EQ(problem_after([](auto& c) { c.votes[0] = -1.0; }), expected);
  EXPECT_EQ(problem_after([](auto& c) { c.label = static_cast<TerrainClass>(4); }), expected);
}

TEST(MixtureCodec, SaysWhatIsWrongAndWhere) {
  std::vector<std::uint8_t> bytes = encode_mixture(sample());
  bytes[4] = 9;
  EXPECT_EQ(decode_mixture(bytes).problem, "byte 4: version 9, expected 2");
  bytes = encode_mixture(sample());
  bytes.back() ^= 1;
  EXPECT_EQ(decode_mixture(bytes).problem, "byte 1863: the checksum does not fit");
  EXPECT_EQ(decode_mixture({}).problem, "ends at byte 0, within the header");
}

}  // namespace
}  // namespace hindsight
