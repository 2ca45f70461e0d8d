// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/send_command.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <memory>

#include "config/exit_code.h"
#include "daemon/command_codec.h"
#include "daemon/command_receiver.h"
#include "daemon/mode.h"
#include "daemon/unix_clock.h"
#include "drivers/unique_fd.h"

namespace hindsight::tools {
namespace {

struct SendOptions {
  std::string to = CommandParams{}.listen;
  std::string key_file;
  double a = 0.0;
  double b = 0.0;
  std::string mode;
};

sockaddr_in endpoint_of(const std::string& text) {
  std::uint32_t address = 0;
  std::uint16_t port = 0;
  if (!parse_endpoint(text, address, port)) {
    throw FatalError(kExitUsage, "--to " + text + ": expected ADDRESS:PORT, such as 127.0.0.1:7668");
  }
  sockaddr_in endpoint{};
  endpoint.sin_family = AF_INET;
  endpoint.sin_addr.s_addr = htonl(address);
  endpoint.sin_port = htons(port);
  return endpoint;
}

int send_command(const SendOptions& options, CommandKind kind) {
  std::optional<CommandKey> key;
  if (!options.key_file.empty()) key = read_command_key(options.key_file);
  const auto packet = encode_command({Time{}, kind, options.a, options.b, 0}, unix_now_us(), key);
  const sockaddr_in endpoint = endpoint_of(options.to);
  const UniqueFd socket(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  const ssize_t sent = sendto(socket.get(), packet.data(), packet.size(), 0,
                              reinterpret_cast<const sockaddr*>(&endpoint), sizeof endpoint);
  if (sent != static_cast<ssize_t>(packet.size())) {
    throw FatalError(kExitIo, "cannot send to " + options.to + ": " + std::strerror(errno));
  }
  return kExitOk;
}

}  // namespace

void add_send(CLI::App& app, Run& run) {
  auto options = std::make_shared<SendOptions>();
  CLI::App* send = app.add_subcommand("send", "Send an operator's command to a running daemon");
  send->require_subcommand(1);
  send->add_option("--to", options->to, "Where the daemon listens (command.listen)")->capture_default_str();
  send->add_option("--key", options->key_file, "File with the key of the commands' MAC (command.key_file)");
  const auto add = [&](const char* name, const char* description, CommandKind kind) {
    CLI::App* command = send->add_subcommand(name, description);
    command->fallthrough();
    command->callback([options, &run, kind] { run = [options, kind] { return send_command(*options, kind); }; });
    return command;
  };
  add("arm", "Permit motion, if nothing forbids it", CommandKind::arm);
  add("disarm", "Forbid motion", CommandKind::disarm);
  add("stop", "Stop, and forget the goal", CommandKind::stop);
  add("release-estop", "After the e-stop button was let go: may be armed again", CommandKind::release_estop);
  add("save-model", "Save the learned mixture", CommandKind::save_model);
  CLI::App* local = add("go-to", "Set the goal, in local metres", CommandKind::go_to_local);
  local->add_option("east_m", options->a, "metres east of the origin")->required();
  local->add_option("north_m", options->b, "metres north of the origin")->required();
  CLI::App* global = add("go-to-gps", "Set the goal, in degrees (WGS84)", CommandKind::go_to_global);
  global->add_option("latitude_deg", options->a)->required()->check(CLI::Range(-90.0, 90.0));
  global->add_option("longitude_deg", options->b)->required()->check(CLI::Range(-180.0, 180.0));
  CLI::App* mode = add("mode", "Change the mode", CommandKind::set_mode);
  mode->add_option("mode", options->mode)->required()->check(CLI::IsMember({"watch", "drive", "road"}));
  mode->parse_complete_callback([options] {
    options->a = static_cast<double>(options->mode == "road"    ? Mode::road
                                    : options->mode == "drive" ? Mode::drive
                                                               : Mode::watch);
  });
}

}  // namespace hindsight::tools
