// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hindsight {

struct LogEvent {
  std::uint64_t offset = 0;  ///< of the event's first byte in the file
  std::int64_t number = 0;
  std::int64_t time_us = 0;
  std::string_view channel;            ///< valid until the next call of next()
  std::span<const std::uint8_t> data;  ///< valid until the next call of next()
};

struct LogDamage {
  std::uint64_t offset = 0;  ///< of the first byte that cannot be believed
  std::string reason;
};

/// Reads any LCM event log event by event. Never believes a length before it fits the file, holds one event
/// in memory at a time, never crashes. After damage the next call goes on at the next sync word. One thread.
class RunLogReader {
 public:
  enum class Result { event, damage, end };

  /// Throws FatalError 66 where the file is absent or unreadable, 65 where it is empty or does not begin as
  /// an LCM event log does; with `recover` a damaged beginning is damage like any other, if a sync word
  /// follows at all.
  explicit RunLogReader(const std::filesystem::path& path, bool recover = false);

  /// Throws FatalError 74 if the disk fails to read.
  Result next();
  const LogEvent& event() const { return event_; }
  const LogDamage& damage() const { return damage_; }

  const std::string& path() const { return path_; }
  std::uint64_t size() const { return size_; }
  std::uint64_t position() const { return position_; }  ///< where the next call reads

 private:
  struct Descriptor {
    int value = -1;
    explicit Descriptor(int descriptor) : value(descriptor) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor();
  };

  Result report_damage(std::uint64_t offset, std::uint64_t resume_at, std::string reason);
  bool sync_at(std::uint64_t offset);
  std::uint64_t find_sync(std::uint64_t from, std::uint64_t to);
  const std::uint8_t* bytes_at(std::uint64_t offset, std::size_t count);
  void fill_window(std::uint64_t offset, std::size_t count);

  std::string path_;
  Descriptor descriptor_;
  std::uint64_t size_ = 0;
  std::uint64_t position_ = 0;
  std::uint64_t window_start_ = 0;
  std::size_t window_size_ = 0;
  std::vector<std::uint8_t> window_;
  LogEvent event_;
  LogDamage damage_;
};

}  // namespace hindsight
