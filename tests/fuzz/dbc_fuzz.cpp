// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// A DBC file as the daemon reads it: parsed, held to the vehicle's roles, then used on frames.
#include "drivers/dbc.h"
#include "drivers/drive_command_codec.h"
#include "drivers/vehicle_decoder.h"
#include "fuzz.h"

namespace hindsight::fuzz {
namespace {

void use(const Dbc& dbc) {
  VehicleDecoder decoder(dbc, {});
  const DriveCommandCodec commands(dbc, {});
  decoder.decode(commands.encode({1.5, -1e300, true}, 0xFFFFFFFFU));
  for (const std::uint32_t id : decoder.received_ids()) {
    decoder.decode({Time(1), id, 8, {0, 1, 2, 3, 0xFC, 0xFD, 0xFE, 0xFF}});
  }
  for (const DbcMessage& message : dbc.messages) {
    for (const DbcSignal& signal : message.signals) {
      if (message.length_bytes > 8) continue;  // of CAN FD: never mapped
      CanPayload payload{};
      encode_signal(payload, signal, 1e300);
      within_limits(signal, decode_signal(payload, signal));
    }
  }
}

void run(Bytes bytes) {
  or_fatal_error([&] { use(parse_dbc(text_of(bytes), "fuzz.dbc")); });
}

}  // namespace
}  // namespace hindsight::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  hindsight::fuzz::run({data, size});
  return 0;
}
