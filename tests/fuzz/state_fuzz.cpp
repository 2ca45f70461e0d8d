// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The file in which gyro bias and last trajectory outlive the process: as it is, and once more with a right
// checksum, so that what stands behind it is reached.
#include "daemon/saved_state.h"
#include "fuzz.h"

namespace hindsight::fuzz {
namespace {

void decode(Bytes bytes) {
  const auto decoded = decode_state(bytes);
  if (!decoded.problem.empty()) return;
  require(decode_state(encode_state(decoded.state)).problem.empty(),
          "what was accepted can be saved and read again");
}

}  // namespace
}  // namespace hindsight::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  hindsight::fuzz::as_it_is_and_sealed({data, size}, hindsight::fuzz::decode);
  return 0;
}
