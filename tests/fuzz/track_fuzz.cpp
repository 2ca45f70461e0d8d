// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// A track that is imported.
#include <cmath>

#include "fuzz.h"
#include "sim_replay/track_csv.h"

namespace hindsight::fuzz {
namespace {

void run(Bytes bytes) {
  static MemoryFile file;
  or_fatal_error([&] {
    TrackCsv track(file.holding(bytes));
    for (TrackRow row; track.next(row);) require(std::isfinite(row.time_s), "time is finite");
  });
}

}  // namespace
}  // namespace hindsight::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  hindsight::fuzz::run({data, size});
  return 0;
}
