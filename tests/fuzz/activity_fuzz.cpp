// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The file in which an activity map outlives the process: as it is, and once more with a right checksum, so
// that what stands behind it is reached.
#include "fuzz.h"
#include "perception/activity_codec.h"

namespace hindsight::fuzz {
namespace {

void decode(Bytes bytes) {
  const auto decoded = decode_activity(bytes);
  if (!decoded.problem.empty()) return;
  require(decode_activity(encode_activity(*decoded.map)).problem.empty(),
          "what was accepted can be saved and read again");
}

}  // namespace
}  // namespace hindsight::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  hindsight::fuzz::as_it_is_and_sealed({data, size}, hindsight::fuzz::decode);
  return 0;
}
