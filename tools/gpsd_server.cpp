// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/gpsd_server.h"

#include <netdb.h>
#include <sys/socket.h>

#include <cerrno>
#include <nlohmann/json.hpp>
#include <string>

#include "config/exit_code.h"
#include "drivers/device_error.h"

namespace hindsight::tools {
namespace {

constexpr double kSigmasOfEstimate = 1.96;  // gpsd's error estimates hold in 95 % of cases

UniqueFd listen_on(const GpsParams& params) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_PASSIVE;
  addrinfo* found = nullptr;
  if (getaddrinfo(params.host.c_str(), params.port.c_str(), &hints, &found) != 0) return {};
  UniqueFd socket(::socket(found->ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const int yes = 1;
  setsockopt(socket.get(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  const bool listens =
      bind(socket.get(), found->ai_addr, found->ai_addrlen) == 0 && listen(socket.get(), 4) == 0;
  const int error = errno;
  freeaddrinfo(found);
  errno = error;
  return listens ? std::move(socket) : UniqueFd();
}

bool tell(const UniqueFd& client, const nlohmann::ordered_json& what) {
  const std::string line = what.dump() + "\r\n";
  return send(client.get(), line.data(), line.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(line.size());
}

nlohmann::ordered_json version() {
  return {{"class", "VERSION"},
          {"release", "3.22"},
          {"rev", "simulated"},
          {"proto_major", 3},
          {"proto_minor", 14}};
}

nlohmann::ordered_json report_of(const GpsFix& fix) {
  const double estimate_m = kSigmasOfEstimate * fix.horizontal_sigma_m;
  return {{"class", "TPV"},          {"device", "simulated"},    {"mode", 3},
          {"lat", fix.latitude_deg}, {"lon", fix.longitude_deg}, {"altHAE", fix.altitude_m},
          {"epx", estimate_m},       {"epy", estimate_m}};
}

}  // namespace

GpsdServer::GpsdServer(const GpsParams& params) : listener_(listen_on(params)) {
  if (!listener_) {
    throw FatalError(kExitNoDevice, DeviceError::from_errno(errno, params.host + ":" + params.port,
                                                            "cannot stand in for gpsd here")
                                        .message);
  }
}

void GpsdServer::serve(std::span<const GpsFix> fixes) {
  while (true) {
    UniqueFd client(accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
    if (!client) break;
    if (tell(client, version())) clients_.push_back(std::move(client));
  }
  for (const GpsFix& fix : fixes) {
    std::erase_if(clients_, [&](const UniqueFd& client) { return !tell(client, report_of(fix)); });
  }
}

}  // namespace hindsight::tools
