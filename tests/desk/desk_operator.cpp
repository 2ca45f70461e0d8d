// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// desk_operator arm | drive | stop | release-estop: an operator's commands to the daemon in the same guest,
// as `hindsight send` sends them, from a program that starts at once; "drive" arms and sends it far ahead.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cstdio>
#include <string>
#include <vector>

#include "daemon/command_codec.h"
#include "daemon/unix_clock.h"
#include "drivers/unique_fd.h"

namespace {

using namespace hindsight;

constexpr std::uint16_t kPort = 7668;
constexpr double kFarAhead_m = 500.0;

std::vector<OperatorCommand> commands_of(const std::string& word) {
  OperatorCommand arm;
  arm.kind = CommandKind::arm;
  OperatorCommand go;
  go.kind = CommandKind::go_to_local;
  go.a = kFarAhead_m;
  OperatorCommand stop;
  OperatorCommand release;
  release.kind = CommandKind::release_estop;
  if (word == "arm") return {arm};
  if (word == "drive") return {arm, go};
  if (word == "stop") return {stop};
  if (word == "release-estop") return {release};
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<OperatorCommand> commands = commands_of(argc == 2 ? argv[1] : "");
  sockaddr_in daemon{};
  daemon.sin_family = AF_INET;
  daemon.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  daemon.sin_port = htons(kPort);
  const UniqueFd socket(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  std::int64_t utime_us = unix_now_us();
  for (const OperatorCommand& command : commands) {
    // Each needs a time of its own, since that is also its number.
    const auto packet = encode_command(command, utime_us++, std::nullopt);
    if (sendto(socket.get(), packet.data(), packet.size(), 0, reinterpret_cast<const sockaddr*>(&daemon),
               sizeof daemon) != static_cast<ssize_t>(packet.size())) {
      std::perror("desk_operator");
      return 1;
    }
  }
  return commands.empty() ? 64 : 0;
}
