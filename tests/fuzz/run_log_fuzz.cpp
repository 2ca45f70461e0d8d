// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// A run log, replayed and recovered: as it is, and once more with right checksums, so that what they guard is
// reached.
#include <vector>

#include "config/crc32.h"
#include "drivers/frame_decoder.h"
#include "fuzz.h"
#include "sim_replay/big_endian.h"
#include "sim_replay/event_log_format.h"
#include "sim_replay/replay_source.h"

namespace hindsight::fuzz {
namespace {

/// An hour between two samples is allowed, and makes a tick of nothing every 0.1 s.
constexpr int kMostTicks = 2000;

void replay(const std::string& path, bool recover) {
  or_fatal_error([&] {
    FramePool pool(4, 0, 0);
    const auto decode = [](Frame& frame) { return decode_frame(frame) == DecodeResult::ok; };
    ReplaySource source(path, pool, decode, {.recover = recover});
    TickInput tick;
    std::vector<PublishedEvent> published;
    for (int i = 0; i < kMostTicks && source.next(tick, &published); ++i) {
      require(source.progress() >= 0.0 && source.progress() <= 1.0, "progress is a share");
    }
  });
}

/// Each event's last four bytes as the checksum of what is before them.
void seal(std::vector<std::uint8_t>& log) {
  for (std::size_t at = 0; at + kEventHeaderBytes <= log.size();) {
    const std::uint64_t channel = read_big_endian<std::uint32_t>(&log[at + 20]);
    const std::uint64_t data = read_big_endian<std::uint32_t>(&log[at + 24]);
    const std::uint64_t begin = at + kEventHeaderBytes + channel;
    if (begin + data > log.size()) return;
    if (data >= 4) {
      const Bytes body = Bytes(log).subspan(begin, data - 4);
      write_big_endian(crc32(body), &log[begin + data - 4]);
    }
    at = begin + data;
  }
}

void run(Bytes bytes) {
  static MemoryFile file;
  std::vector<std::uint8_t> log(bytes.begin(), bytes.end());
  for (const bool sealed : {false, true}) {
    if (sealed) seal(log);
    const std::string& path = file.holding(log);
    replay(path, false);
    replay(path, true);
  }
}

}  // namespace
}  // namespace hindsight::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  hindsight::fuzz::run({data, size});
  return 0;
}
