// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace hindsight {

/// Where the events of a log go: a file, or memory.
class EventSink {
 public:
  virtual ~EventSink() = default;
  /// Adds an event with `size` bytes of data and returns them for the caller to fill before the next call;
  /// empty where it is not taken.
  virtual std::span<std::uint8_t> append(std::string_view channel, std::int64_t time_us,
                                         std::size_t size) = 0;
};

}  // namespace hindsight
