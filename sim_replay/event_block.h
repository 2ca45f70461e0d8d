// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "sim_replay/event_sink.h"

namespace hindsight {

/// Whole events of an LCM event log (event_log_format.h) in memory, numbered on from block to block. No
/// allocation once it has grown to the largest block.
class EventBlock : public EventSink {
 public:
  std::span<std::uint8_t> append(std::string_view channel, std::int64_t time_us, std::size_t size) override;
  std::span<const std::uint8_t> bytes() const { return bytes_; }
  void clear() { bytes_.clear(); }
  void reserve(std::size_t bytes) { bytes_.reserve(bytes); }

 private:
  std::vector<std::uint8_t> bytes_;
  std::int64_t next_number_ = 0;
};

}  // namespace hindsight
