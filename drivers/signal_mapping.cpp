// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "drivers/signal_mapping.h"

#include <fmt/format.h>

#include <array>

#include "config/exit_code.h"

namespace hindsight {
namespace {

struct Role {
  const char* name;
  std::string CanRolesParams::*source;
  const char* unit;
  SignalGroup group;
  double VehicleSignals::*value;
  bool required = false;
};

using G = SignalGroup;
using P = CanRolesParams;
using V = VehicleSignals;
constexpr std::array<Role, 10> kRoles{{
    {"left_speed", &P::left_speed, "m/s", G::wheels, &V::left_mps, true},
    {"right_speed", &P::right_speed, "m/s", G::wheels, &V::right_mps, true},
    {"left_ticks", &P::left_ticks, "", G::ticks, &V::left_ticks},
    {"right_ticks", &P::right_ticks, "", G::ticks, &V::right_ticks},
    {"left_current", &P::left_current, "A", G::currents, &V::left_a},
    {"right_current", &P::right_current, "A", G::currents, &V::right_a},
    {"left_range", &P::left_range, "m", G::ir_ranges, &V::ir_left_m},
    {"right_range", &P::right_range, "m", G::ir_ranges, &V::ir_right_m},
    {"battery_voltage", &P::battery_voltage, "V", G::battery, &V::battery_v},
    {"yaw_rate", &P::yaw_rate, "rad/s", G::imu, &V::yaw_rate_radps},
}};

// A vehicle that has the left one of a pair has the right one: half a pair is a slip of the pen.
void check_pairs(const CanRolesParams& roles) {
  for (const Role& one : kRoles) {
    for (const Role& other : kRoles) {
      if (one.group == other.group && !(roles.*one.source).empty() && (roles.*other.source).empty()) {
        throw FatalError(kExitConfiguration,
                         fmt::format("can role {} is empty, but {} is {}: give both or neither", other.name,
                                     one.name, roles.*one.source));
      }
    }
  }
}

MappedMessage& message_of(std::vector<MappedMessage>& messages, const Dbc& dbc, const DbcMessage& message,
                          const CanRolesParams& roles) {
  for (MappedMessage& mapped : messages) {
    if (mapped.message.name() == message.name) return mapped;
  }
  messages.push_back({ProtectedMessage(dbc, message, roles.counter, roles.checksum), {}});
  return messages.back();
}

}  // namespace

RoleSignal find_role(const Dbc& dbc, const char* role, const std::string& source, const char* unit) {
  const auto refuse = [&](const std::string& why) {
    throw FatalError(kExitConfiguration,
                     fmt::format("{}: can role {} = \"{}\": {}", dbc.path, role, source, why));
  };
  const std::size_t dot = source.find('.');
  if (dot == std::string::npos) refuse("expected MESSAGE.SIGNAL");
  const DbcMessage* message = dbc.find(source.substr(0, dot));
  if (message == nullptr) refuse(fmt::format("the file has no message {}", source.substr(0, dot)));
  const DbcSignal* signal = message->find(source.substr(dot + 1));
  if (signal == nullptr) {
    refuse(fmt::format("message {} (line {}) has no signal {}", message->name, message->line,
                       source.substr(dot + 1)));
  }
  if (!signal->unsupported.empty())
    refuse(fmt::format("the signal is {}, which is not supported", signal->unsupported));
  if (signal->length_bits > kMostRoleBits)
    refuse(fmt::format("the signal has more than {} bits", kMostRoleBits));
  if (signal->unit != unit)
    refuse(fmt::format("expected unit \"{}\", the file has \"{}\"", unit, signal->unit));
  return {message, signal};
}

std::vector<MappedMessage> map_sensor_messages(const Dbc& dbc, const CanRolesParams& roles) {
  check_pairs(roles);
  std::vector<MappedMessage> messages;
  for (std::size_t i = 0; i < kRoles.size(); ++i) {
    const Role& role = kRoles[i];
    const std::string& source = roles.*role.source;
    if (source.empty() && !role.required) continue;
    const RoleSignal found = find_role(dbc, role.name, source, role.unit);
    MappedMessage& mapped = message_of(messages, dbc, *found.message, roles);
    for (const MappedMessage::Binding& other : mapped.bindings) {
      if (other.signal.name == found.signal->name) {
        throw FatalError(kExitConfiguration,
                         fmt::format("{}: can role {} = \"{}\": another role has this signal", dbc.path,
                                     role.name, source));
      }
    }
    mapped.bindings.push_back({*found.signal, role.value, role.group, 1U << i});
  }
  return messages;
}

}  // namespace hindsight
