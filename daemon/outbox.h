// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace hindsight {

/// The messages that one tick publishes, encoded: the same bytes go to LCM, to the run log and to verify. Memory is
/// reserved at construction; a message that does not fit is dropped and counted (size the arena so that it never is).
class Outbox {
 public:
  struct Message {
    std::string_view channel;  ///< a string literal
    std::int64_t utime_us = 0;
    std::span<const std::uint8_t> bytes;
  };

  explicit Outbox(std::size_t arena_bytes = 512 * 1024, std::size_t messages = 64) : arena_(arena_bytes) {
    messages_.reserve(messages);
  }

  void clear() {
    used_ = 0;
    messages_.clear();
  }

  /// Encodes an lcm-gen message (getEncodedSize, encode). `channel` must outlive the outbox.
  template <typename LcmType>
  void add(std::string_view channel, std::int64_t utime_us, const LcmType& message) {
    const auto size = static_cast<std::size_t>(message.getEncodedSize());
    if (arena_.size() - used_ < size || messages_.size() == messages_.capacity()) {
      ++dropped_;
      return;
    }
    std::uint8_t* begin = arena_.data() + used_;
    message.encode(begin, 0, static_cast<int>(size));
    messages_.push_back({channel, utime_us, {begin, size}});
    used_ += size;
  }

  std::span<const Message> messages() const { return messages_; }
  std::uint32_t dropped() const { return dropped_; }

 private:
  std::vector<std::uint8_t> arena_;
  std::size_t used_ = 0;
  std::vector<Message> messages_;
  std::uint32_t dropped_ = 0;
};

}  // namespace hindsight
