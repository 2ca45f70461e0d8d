// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/command_receiver.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include <cerrno>
#include <charconv>
#include <cstring>

#include "config/exit_code.h"
#include "daemon/unix_clock.h"
#include "drivers/monotonic_clock.h"
#include "drivers/wait.h"

namespace hindsight {
namespace {

constexpr int kPacketsPerService = 32;

bool is_loopback(std::uint32_t address_host_order) { return (address_host_order >> 24U) == 127U; }

sockaddr_in checked_endpoint(const CommandParams& params) {
  std::uint32_t address = 0;
  std::uint16_t port = 0;
  if (!parse_endpoint(params.listen, address, port)) {
    throw FatalError(kExitConfiguration,
                     fmt::format("command.listen = \"{}\": expected ADDRESS:PORT, such as 127.0.0.1:7668", params.listen));
  }
  if (!is_loopback(address) && params.key_file.empty()) {
    throw FatalError(kExitConfiguration,
                     fmt::format("command.listen = \"{}\" is open to the network: command.key_file must be set",
                                 params.listen));
  }
  sockaddr_in endpoint{};
  endpoint.sin_family = AF_INET;
  endpoint.sin_addr.s_addr = htonl(address);
  endpoint.sin_port = htons(port);
  return endpoint;
}

UniqueFd bound_socket(const CommandParams& params) {
  const sockaddr_in endpoint = checked_endpoint(params);
  UniqueFd socket(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!socket || bind(socket.get(), reinterpret_cast<const sockaddr*>(&endpoint), sizeof endpoint) != 0) {
    throw FatalError(kExitNoDevice,
                     fmt::format("command.listen = \"{}\": cannot bind: {}", params.listen, std::strerror(errno)));
  }
  return socket;
}

std::optional<CommandKey> key_of(const CommandParams& params) {
  if (params.key_file.empty()) return std::nullopt;
  return read_command_key(params.key_file);
}

}  // namespace

bool parse_endpoint(const std::string& text, std::uint32_t& address_host_order, std::uint16_t& port) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos) return false;
  in_addr address{};
  if (inet_pton(AF_INET, text.substr(0, colon).c_str(), &address) != 1) return false;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data() + colon + 1, end, port);
  address_host_order = ntohl(address.s_addr);
  return parsed.ec == std::errc() && parsed.ptr == end;
}

CommandReceiver::CommandReceiver(const CommandParams& params)
    : socket_(bound_socket(params)), decoder_(key_of(params), static_cast<std::int64_t>(params.window_s * 1e6)) {}

void CommandReceiver::service(Time timeout, int stop_fd, std::vector<OperatorCommand>& accepted) {
  pollfd waiting{socket_.get(), POLLIN, 0};
  if (!wait_for(std::span(&waiting, 1), timeout, stop_fd) || waiting.revents == 0) return;
  // One byte more than any accepted packet would do; longer ones are cut and then refused for their size.
  std::array<std::uint8_t, 256> packet;
  for (int i = 0; i < kPacketsPerService; ++i) {
    const ssize_t size = recv(socket_.get(), packet.data(), packet.size(), 0);
    if (size < 0) return;
    OperatorCommand command;
    const CommandVerdict verdict =
        decoder_.decode(std::span(packet).first(static_cast<std::size_t>(size)), monotonic_now(), unix_now_us(), command);
    counts_[static_cast<std::size_t>(verdict)].fetch_add(1, std::memory_order_relaxed);
    if (verdict == CommandVerdict::accepted) accepted.push_back(command);
  }
}

std::uint16_t CommandReceiver::port() const {
  sockaddr_in endpoint{};
  socklen_t size = sizeof endpoint;
  getsockname(socket_.get(), reinterpret_cast<sockaddr*>(&endpoint), &size);
  return ntohs(endpoint.sin_port);
}

}  // namespace hindsight
