// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/command_codec.h"

#include <fmt/format.h>
#include <sodium.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <hindsight/command_t.hpp>
#include <string_view>

#include "config/exit_code.h"

namespace hindsight {
namespace {

constexpr std::string_view kChannel = "HINDSIGHT_COMMAND";
constexpr std::array<std::uint8_t, 4> kShortMagic = {0x4c, 0x43, 0x30, 0x32};
constexpr std::size_t kHeaderBytes = 8;
constexpr std::size_t kMacBytes = 32;
static_assert(kMacBytes == crypto_auth_BYTES && kCommandKeyBytes == crypto_auth_KEYBYTES);

using Mac = std::array<std::uint8_t, kMacBytes>;

/// The MAC is taken over the encoded message with its mac field all zero, which is the encoding's end.
Mac mac_of(std::span<const std::uint8_t> payload, const CommandKey& key) {
  std::array<std::uint8_t, 128> zeroed{};
  std::copy(payload.begin(), payload.end() - kMacBytes, zeroed.begin());
  Mac mac{};
  crypto_auth(mac.data(), zeroed.data(), payload.size(), key.data());
  return mac;
}

bool known_and_finite(const command_t& message) {
  return message.kind >= 0 && message.kind <= static_cast<int>(CommandKind::save_model) && std::isfinite(message.a) &&
         std::isfinite(message.b);
}

int encoded_size() { return command_t().getEncodedSize(); }

}  // namespace

CommandDecoder::CommandDecoder(std::optional<CommandKey> key, std::int64_t window_us)
    : key_(key), window_us_(window_us) {}

CommandVerdict CommandDecoder::decode(std::span<const std::uint8_t> packet, Time stamp, std::int64_t utime_us,
                                      OperatorCommand& command) {
  if (packet.size() < kHeaderBytes || !std::equal(kShortMagic.begin(), kShortMagic.end(), packet.begin())) {
    return CommandVerdict::malformed;
  }
  const auto body = packet.subspan(kHeaderBytes);
  const auto terminator = std::find(body.begin(), body.end(), 0);
  if (terminator == body.end()) return CommandVerdict::malformed;
  const auto channel_length = static_cast<std::size_t>(terminator - body.begin());
  if (!std::equal(body.begin(), terminator, kChannel.begin(), kChannel.end())) return CommandVerdict::wrong_channel;

  const auto payload = body.subspan(channel_length + 1);
  command_t message;
  if (payload.size() != static_cast<std::size_t>(encoded_size()) ||
      message.decode(payload.data(), 0, static_cast<int>(payload.size())) != encoded_size()) {
    return CommandVerdict::malformed;
  }
  if (key_ && sodium_memcmp(mac_of(payload, *key_).data(), message.mac, kMacBytes) != 0) {
    return CommandVerdict::wrong_mac;
  }
  if (!known_and_finite(message)) return CommandVerdict::bad_value;
  if (static_cast<CommandKind>(message.kind) != CommandKind::stop) {
    const CommandVerdict verdict = judge_age(message.utime, message.sequence, utime_us);
    if (verdict != CommandVerdict::accepted) return verdict;
    last_sequence_ = message.sequence;
  }
  command = {stamp, static_cast<CommandKind>(message.kind), message.a, message.b, message.sequence};
  return CommandVerdict::accepted;
}

CommandVerdict CommandDecoder::judge_age(std::int64_t sent_us, std::int64_t sequence, std::int64_t now_us) {
  const bool timely = sent_us >= now_us - window_us_ && sent_us <= now_us + window_us_;
  if (!timely || sequence > now_us + window_us_) return CommandVerdict::untimely;
  if (last_sequence_ > now_us + window_us_) last_sequence_ = 0;  // our clock was set back since
  return sequence > last_sequence_ ? CommandVerdict::accepted : CommandVerdict::replayed;
}

std::vector<std::uint8_t> encode_command(const OperatorCommand& command, std::int64_t utime_us,
                                         const std::optional<CommandKey>& key) {
  command_t message{};
  message.utime = utime_us;
  message.sequence = utime_us;
  message.kind = static_cast<std::int8_t>(command.kind);
  message.a = command.a;
  message.b = command.b;
  const std::size_t start = kHeaderBytes + kChannel.size() + 1;
  std::vector<std::uint8_t> packet(start + static_cast<std::size_t>(encoded_size()));
  std::copy(kShortMagic.begin(), kShortMagic.end(), packet.begin());
  std::copy(kChannel.begin(), kChannel.end(), packet.begin() + kHeaderBytes);
  message.encode(packet.data() + start, 0, encoded_size());
  if (key) {
    const Mac mac = mac_of(std::span(packet).subspan(start), *key);
    std::copy(mac.begin(), mac.end(), packet.end() - kMacBytes);
  }
  return packet;
}

CommandKey read_command_key(const std::string& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0) {
    throw FatalError(kExitConfiguration, fmt::format("{}: cannot read the command key: {}", file, std::strerror(errno)));
  }
  if ((status.st_mode & (S_IRWXG | S_IRWXO)) != 0) {
    throw FatalError(kExitConfiguration,
                     fmt::format("{}: the command key may be read by others (mode {:o}); set mode 600", file,
                                 status.st_mode & 0777U));
  }
  std::string text;
  std::ifstream(file) >> text;
  CommandKey key{};
  std::size_t length = 0;
  if (sodium_hex2bin(key.data(), key.size(), text.data(), text.size(), nullptr, &length, nullptr) != 0 ||
      length != key.size()) {
    throw FatalError(kExitConfiguration, fmt::format("{}: a command key is 64 hexadecimal digits", file));
  }
  return key;
}

}  // namespace hindsight
