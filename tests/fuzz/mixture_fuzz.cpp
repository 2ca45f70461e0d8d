// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The file in which a learned mixture outlives the process: as it is, and once more with a right checksum, so
// that what stands behind it is reached.
#include "fuzz.h"
#include "perception/mixture_codec.h"

namespace hindsight::fuzz {
namespace {

void decode(Bytes bytes) {
  const auto decoded = decode_mixture(bytes);
  if (!decoded.problem.empty()) return;
  require(decode_mixture(encode_mixture(decoded.mixture)).problem.empty(),
          "what was accepted can be saved and read again");
}

}  // namespace
}  // namespace hindsight::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  hindsight::fuzz::as_it_is_and_sealed({data, size}, hindsight::fuzz::decode);
  return 0;
}
