// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
// Our codec against two other DBC decoders: canmatrix (python3-canmatrix) and candied (npm ci in
// tests/support/dbc_peers). They disagree about the start bit of big-endian signals, where candied is at odds
// with the format; it gets none.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <linux/can.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>
#include <sstream>

#include "drivers/can_codec.h"

namespace hindsight {
namespace {

const std::string kPeers = HINDSIGHT_SOURCE_DIR "/tests/support/dbc_peers";
const std::string kLagr = HINDSIGHT_SOURCE_DIR "/config/lagr.dbc";

struct Sample {
  const DbcMessage* message;
  CanPayload data;
};

std::string hex_of(const Sample& sample) {
  std::string text;
  for (std::size_t i = 0; i < static_cast<std::size_t>(sample.message->length_bytes); ++i) {
    text += fmt::format("{:02x}", sample.data[i]);
  }
  return text;
}

/// A folder for this test's files, removed at its end.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "dbc_peers_XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~ScratchFolder() { std::filesystem::remove_all(path_); }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// Runs a peer over the requests and returns its lines.
std::vector<std::string> ask(const std::string& peer, const std::string& dbc, const std::string& requests) {
  const ScratchFolder scratch;
  std::ofstream(scratch.file("in")) << requests;
  const std::string out = scratch.file("out");
  const std::string command = fmt::format("cd '{}' && {} '{}' < '{}' > '{}' 2> /dev/null", kPeers, peer, dbc,
                                          scratch.file("in"), out);
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  std::vector<std::string> lines;
  std::ifstream file(out);
  for (std::string line; std::getline(file, line);) {
    if (line.find("is not supported") == std::string::npos)
      lines.push_back(line);  // canmatrix on its own formats
  }
  return lines;
}

std::vector<Sample> random_samples(const Dbc& dbc, unsigned seed, int count) {
  std::mt19937_64 random(seed);
  std::vector<Sample> samples;
  for (const DbcMessage& message : dbc.messages) {
    for (int i = 0; i < count; ++i) {
      Sample sample{&message, {}};
      for (std::size_t byte = 0; byte < static_cast<std::size_t>(message.length_bytes); ++byte) {
        sample.data[byte] = static_cast<std::uint8_t>(random());
      }
      samples.push_back(sample);
    }
  }
  return samples;
}

std::int64_t raw_value(const CanPayload& data, DbcSignal signal) {
  signal.factor = 1.0;
  signal.offset = 0.0;
  return std::llround(decode_signal(data, signal));
}

/// `clamps`: the peer holds its values to the declared limits, so that only raw values compare beyond them.
void expect_same_decoding(const std::string& peer, const std::string& path,
                          const std::vector<Sample>& samples, bool clamps) {
  std::string requests;
  for (const Sample& sample : samples)
    requests += fmt::format("decode {} {}\n", sample.message->id, hex_of(sample));
  const std::vector<std::string> answers = ask(peer, path, requests);
  ASSERT_EQ(answers.size(), samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    std::string line = answers[i];
    for (char& c : line) c = c == '=' ? ' ' : c;
    std::istringstream words(line);
    std::string name;
    words >> name;
    EXPECT_EQ(name, samples[i].message->name);
    std::size_t signals = 0;
    double raw = 0.0, value = 0.0;
    for (; words >> name >> raw >> value; ++signals) {
      const DbcSignal* signal = samples[i].message->find(name);
      ASSERT_NE(signal, nullptr) << name;
      EXPECT_EQ(static_cast<double>(raw_value(samples[i].data, *signal)), raw) << answers[i];
      const double ours = decode_signal(samples[i].data, *signal);
      if (!clamps || within_limits(*signal, ours)) {
        EXPECT_NEAR(ours, value, 1e-9 * std::max(1.0, std::abs(value))) << answers[i];
      }
    }
    EXPECT_EQ(signals, samples[i].message->signals.size());
  }
}

/// Messages filled with signals of random lengths, byte orders, signs and scales.
std::string random_dbc(unsigned seed, int messages) {
  std::mt19937 random(seed);
  std::string text = "VERSION \"\"\n\nBU_: A B\n";
  for (int m = 0; m < messages; ++m) {
    const bool little = m % 2 == 0;
    text += fmt::format("\nBO_ {} MSG{}: 8 A\n",
                        (m % 4 < 2 ? 100U : 0x80000000U + 70000U) + static_cast<unsigned>(m), m);
    int first = 0;
    for (int s = 0; first < 64; ++s) {
      const int length = std::min(1 + static_cast<int>(random() % 24), 64 - first);
      text += fmt::format(" SG_ S{} : {}|{}@{}{} ({},{}) [0|0] \"\" B\n", s,
                          little ? first : first / 8 * 8 + 7 - first % 8, length, little ? 1 : 0,
                          random() % 2 == 0 ? '+' : '-', static_cast<double>(1 + random() % 1000) / 1000.0,
                          static_cast<int>(random() % 200) - 100);
      first += length + static_cast<int>(random() % 3);
    }
  }
  return text;
}

bool has(const char* command) {
  return std::system(fmt::format("{} > /dev/null 2>&1", command).c_str()) == 0;
}

constexpr const char* kCanmatrix = "/usr/bin/python3 canmatrix_peer.py";
class Canmatrix : public testing::Test {
 protected:
  void SetUp() override {
    if (!has("/usr/bin/python3 -c 'import canmatrix'")) GTEST_SKIP() << "python3-canmatrix is not installed";
  }
};

TEST_F(Canmatrix, DecodesTheVehiclesFramesAsWeDo) {
  const Dbc dbc = read_dbc(kLagr);
  expect_same_decoding(kCanmatrix, kLagr, random_samples(dbc, 20260106, 100), false);
}

TEST_F(Canmatrix, DecodesRandomMessagesOfBothByteOrdersAsWeDo) {
  const ScratchFolder scratch;
  const std::string path = scratch.file("random.dbc");
  std::ofstream(path) << random_dbc(20260107, 40);
  const Dbc dbc = read_dbc(path);
  expect_same_decoding(kCanmatrix, path, random_samples(dbc, 20260108, 10), false);
}

TEST_F(Canmatrix, EncodesAsWeDo) {
  const ScratchFolder scratch;
  const std::string path = scratch.file("random.dbc");
  std::ofstream(path) << random_dbc(20260109, 40);
  const Dbc dbc = read_dbc(path);
  const std::vector<Sample> samples = random_samples(dbc, 20260110, 10);
  std::string requests;
  std::vector<std::string> expected;
  for (const Sample& sample : samples) {
    Sample ours{sample.message, {}};
    requests += "encode " + sample.message->name;
    for (const DbcSignal& signal : sample.message->signals) {
      requests += fmt::format(" {}={}", signal.name, raw_value(sample.data, signal));
      encode_signal(ours.data, signal, decode_signal(sample.data, signal));
    }
    requests += "\n";
    expected.push_back(fmt::format("{} {}", sample.message->id, hex_of(ours)));
  }
  EXPECT_EQ(ask(kCanmatrix, path, requests), expected);
}

TEST(Candied, DecodesTheVehiclesFramesAsWeDo) {
  if (!has("node --version") || !std::filesystem::exists(kPeers + "/node_modules/candied")) {
    GTEST_SKIP() << "candied is not installed (npm ci in tests/support/dbc_peers)";
  }
  const Dbc dbc = read_dbc(kLagr);
  expect_same_decoding("node candied_peer.mjs", kLagr, random_samples(dbc, 20260111, 100), true);
}

}  // namespace
}  // namespace hindsight
