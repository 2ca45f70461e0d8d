// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/event_block.h"

#include <algorithm>

#include "sim_replay/big_endian.h"
#include "sim_replay/event_log_format.h"

namespace hindsight {
namespace {

void write_event_header(std::uint8_t* to, std::int64_t number, std::int64_t time_us,
                        std::size_t channel_length, std::size_t size) {
  write_big_endian(kEventSync, to);
  write_big_endian(number, to + 4);
  write_big_endian(time_us, to + 12);
  write_big_endian(static_cast<std::int32_t>(channel_length), to + 20);
  write_big_endian(static_cast<std::int32_t>(size), to + 24);
}

}  // namespace

std::span<std::uint8_t> EventBlock::append(std::string_view channel, std::int64_t time_us, std::size_t size) {
  const std::size_t begin = bytes_.size();
  bytes_.resize(begin + kEventHeaderBytes + channel.size() + size);
  std::uint8_t* const to = bytes_.data() + begin;
  write_event_header(to, next_number_++, time_us, channel.size(), size);
  std::copy(channel.begin(), channel.end(), to + kEventHeaderBytes);
  return {to + kEventHeaderBytes + channel.size(), size};
}

}  // namespace hindsight
