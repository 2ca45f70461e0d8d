// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "drivers/dbc.h"

#include <fmt/format.h>

#include <algorithm>
#include <bitset>
#include <cmath>
#include <fstream>
#include <sstream>

#include "config/exit_code.h"
#include "drivers/dbc_text.h"

namespace hindsight {
namespace {

constexpr std::uint32_t kExtendedBit = 0x80000000U;
constexpr std::uint32_t kLargestStandardId = 0x7FFU;
constexpr int kMostBytes = 64;  // of a CAN FD message, which may stand in the file beside ours
// Tools keep signals without a message here; it never appears on a bus.
constexpr std::string_view kNoMessage = "VECTOR__INDEPENDENT_SIG_MSG";

using MessageBits = std::bitset<kMostBytes * 8>;

/// The places of a signal's bits: 8 * byte + bit. False where one lies outside the message.
bool mark_bits(const DbcSignal& signal, int length_bytes, MessageBits& bits) {
  int position = signal.start_bit;
  for (int i = 0; i < signal.length_bits; ++i) {
    if (position >= length_bytes * 8) return false;
    bits.set(static_cast<std::size_t>(position));
    if (signal.little_endian)
      ++position;
    else
      position += position % 8 == 0 ? 15 : -1;  // from a byte's bit 0 on to the next byte's bit 7
  }
  return true;
}

// BO_ 256 WHEEL_ENCODERS: 8 BASE
DbcMessage read_message(LineScanner& line) {
  DbcMessage message;
  const auto id = line.number<std::uint32_t>("the message's identifier");
  message.extended = (id & kExtendedBit) != 0;
  message.id = id & ~kExtendedBit;
  message.name = line.name("the message's name");
  line.expect(':');
  message.length_bytes = line.number<int>("the message's length");
  message.sender = line.name("the message's sender");
  if (message.length_bytes < 0 || message.length_bytes > kMostBytes) line.fail("a length from 0 to 64 bytes");
  if (!message.extended && message.id > kLargestStandardId)
    line.fail("an identifier of 11 bits, or bit 31 set");
  return message;
}

// SG_ LEFT_SPEED : 0|14@1- (0.001,0) [-5|5] "m/s" HINDSIGHT
DbcSignal read_signal(LineScanner& line) {
  DbcSignal signal;
  signal.name = line.name("the signal's name");
  if (!line.word().empty()) signal.unsupported = "multiplexed";
  line.expect(':');
  signal.start_bit = line.number<int>("the start bit");
  line.expect('|');
  signal.length_bits = line.number<int>("the length in bits");
  line.expect('@');
  signal.little_endian = line.accept('1');
  if (!signal.little_endian && !line.accept('0')) line.fail("byte order 0 or 1");
  signal.is_signed = line.accept('-');
  if (!signal.is_signed && !line.accept('+')) line.fail("sign + or -");
  line.expect('(');
  signal.factor = line.number<double>("the factor");
  line.expect(',');
  signal.offset = line.number<double>("the offset");
  line.expect(')');
  line.expect('[');
  signal.min = line.number<double>("the smallest value");
  line.expect('|');
  signal.max = line.number<double>("the largest value");
  line.expect(']');
  signal.unit = line.quoted();
  line.name("the receiver");
  if (signal.start_bit < 0 || signal.length_bits < 1 || signal.length_bits > 64)
    line.fail("1 to 64 bits from bit 0 up");
  if (!std::isfinite(signal.factor) || signal.factor == 0.0 || !std::isfinite(signal.offset)) {
    line.fail("a factor other than 0 and finite numbers");
  }
  if (!(signal.min <= signal.max)) line.fail("limits in ascending order");
  return signal;
}

class Parser {
 public:
  Parser(std::string_view text, const std::string& path) : lines_(text) { dbc_.path = path; }

  Dbc parse() {
    std::string_view line;
    while (lines_.next(line)) {
      if (!lines_.began_quoted()) parse_line(line);
    }
    if (lines_.quoted())
      throw FatalError(kExitConfiguration, place() + ": the file ends inside a quoted text");
    if (dbc_.messages.empty()) throw FatalError(kExitConfiguration, dbc_.path + ": holds no message (BO_)");
    return std::move(dbc_);
  }

 private:
  std::string place() const { return fmt::format("{}:{}", dbc_.path, lines_.number()); }

  void parse_line(std::string_view text) {
    // What is indented, except for signals, lists the file's keywords (NS_) or goes on from the line before.
    const bool indented = !text.empty() && is_blank(text.front());
    LineScanner line(text, place());
    const std::string keyword = line.word();
    if (keyword == "SG_") return add_signal(line);
    if (indented) return;
    in_message_ = keyword == "BO_";
    if (in_message_) return add_message(line);
    if (keyword == "SIG_VALTYPE_") return mark_floating_point(line);
  }

  void add_message(LineScanner& line) {
    DbcMessage message = read_message(line);
    message.line = lines_.number();
    taken_.reset();
    in_real_message_ = message.name != kNoMessage;
    if (!in_real_message_) return;
    for (const DbcMessage& other : dbc_.messages) {
      const bool same_id = other.id == message.id && other.extended == message.extended;
      if (same_id || other.name == message.name) {
        throw FatalError(kExitConfiguration,
                         fmt::format("{}: message {} has the name or identifier of line {}", line.place(),
                                     message.name, other.line));
      }
    }
    dbc_.messages.push_back(std::move(message));
  }

  void add_signal(LineScanner& line) {
    if (!in_message_) line.fail("a signal inside a message");
    DbcSignal signal = read_signal(line);
    if (!in_real_message_) return;
    DbcMessage& message = dbc_.messages.back();
    const auto refuse = [&](const char* why) {
      throw FatalError(kExitConfiguration,
                       fmt::format("{}: {}.{} {}", line.place(), message.name, signal.name, why));
    };
    if (message.find(signal.name) != nullptr) refuse("is there twice");
    MessageBits bits;
    if (!mark_bits(signal, message.length_bytes, bits)) refuse("does not fit into its message");
    if (signal.unsupported.empty()) {  // switched signals share their bits
      if ((bits & taken_).any()) refuse("overlaps with another signal");
      taken_ |= bits;
    }
    message.signals.push_back(std::move(signal));
  }

  // SIG_VALTYPE_ 256 LEFT_SPEED : 1;
  void mark_floating_point(LineScanner& line) {
    const auto id = line.number<std::uint32_t>("a message's identifier");
    const std::string name = line.name("a signal's name");
    for (DbcMessage& message : dbc_.messages) {
      if (message.id != (id & ~kExtendedBit) || message.extended != ((id & kExtendedBit) != 0)) continue;
      for (DbcSignal& signal : message.signals) {
        if (signal.name == name) signal.unsupported = "floating point";
      }
    }
  }

  LineSplitter lines_;
  Dbc dbc_;
  bool in_message_ = false;
  bool in_real_message_ = false;
  MessageBits taken_;
};

}  // namespace

const DbcSignal* DbcMessage::find(std::string_view signal) const {
  const auto found =
      std::find_if(signals.begin(), signals.end(), [&](const DbcSignal& s) { return s.name == signal; });
  return found == signals.end() ? nullptr : &*found;
}

const DbcMessage* Dbc::find(std::string_view message) const {
  const auto found =
      std::find_if(messages.begin(), messages.end(), [&](const DbcMessage& m) { return m.name == message; });
  return found == messages.end() ? nullptr : &*found;
}

Dbc parse_dbc(std::string_view text, const std::string& path) { return Parser(text, path).parse(); }

Dbc read_dbc(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf()))
    throw FatalError(kExitNoInput, path + ": cannot be read, or is empty");
  return parse_dbc(text.view(), path);
}

}  // namespace hindsight
