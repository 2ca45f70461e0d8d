// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Frames of the bus, as the kernel may hand them over, into the decoder of the LAGR's protocol. Some are
// sealed with a right checksum, so that what stands behind it is reached.
#include <linux/can.h>

#include <cmath>

#include "drivers/can_codec.h"
#include "drivers/drive_command_codec.h"
#include "drivers/vehicle_decoder.h"
#include "fuzz.h"

namespace hindsight::fuzz {
namespace {

const Dbc& lagr() {
  static const Dbc dbc = read_dbc(HINDSIGHT_SOURCE_DIR "/config/lagr.dbc");
  return dbc;
}

CanFrame take_frame(Reader& in, bool& sealed) {
  const auto how = in.take<std::uint8_t>();
  sealed = (how & 1U) != 0;
  CanFrame frame;
  frame.stamp = Time(in.take<std::uint32_t>());
  const auto id = in.take<std::uint32_t>();
  const auto& messages = lagr().messages;
  frame.id = (how & 2U) != 0 ? messages[id % messages.size()].id : id;
  frame.length =
      std::min<std::uint8_t>(in.take<std::uint8_t>(), 8);  // all that a socket of classic CAN gives
  const Bytes data = in.take(8);
  std::copy(data.begin(), data.end(), frame.data.begin());
  return frame;
}

void seal(CanFrame& frame, std::uint32_t counter) {
  const CanRolesParams roles;
  for (const DbcMessage& message : lagr().messages) {
    if (message.id == frame.id)
      ProtectedMessage(lagr(), message, roles.counter, roles.checksum).seal(frame, counter);
  }
}

void require_finite(const VehicleSignals& s) {
  for (const double value : {s.left_mps, s.right_mps, s.left_ticks, s.right_ticks, s.left_a, s.right_a,
                             s.ir_left_m, s.ir_right_m, s.battery_v, s.yaw_rate_radps}) {
    require(std::isfinite(value), "every signal is finite");
  }
}

void run(Bytes bytes) {
  Reader in(bytes);
  VehicleDecoder decoder(lagr(), {});
  const DriveCommandCodec commands(lagr(), {});
  for (std::uint32_t counter = 0; !in.empty(); ++counter) {
    bool sealed = false;
    CanFrame frame = take_frame(in, sealed);
    if (sealed) seal(frame, counter);
    decoder.decode(frame);
    require_finite(decoder.signals());
    WheelSetpoints setpoints;
    std::uint32_t told = 0;
    commands.decode(frame, setpoints, told);
  }
}

}  // namespace
}  // namespace hindsight::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  hindsight::fuzz::run({data, size});
  return 0;
}
