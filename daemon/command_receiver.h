// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "config/params.h"
#include "daemon/command_codec.h"
#include "drivers/unique_fd.h"

namespace hindsight {

struct CommandParams {
  std::string listen = "127.0.0.1:7668";
  std::string key_file;
  double window_s = 5.0;

  void visit(auto&& param) {
    param("listen", listen, AnyText{}, "address and UDP port for operator commands; empty: none are taken");
    param("key_file", key_file, AnyText{},
          "file with the key of the commands' MAC; required where `listen` is not a loopback address");
    param("window_s", window_s, Range{0.1, 3600.0}, "how far a command's time may be from the vehicle's clock [s]");
  }
};

/// The only thing in the process that listens: one UDP socket, bounded reads, nothing but CommandDecoder behind it.
/// Used by one thread; counters may be read by any.
class CommandReceiver {
 public:
  /// FatalError(kExitConfiguration) on a bad address or a missing key, FatalError(kExitNoDevice) if it cannot bind.
  explicit CommandReceiver(const CommandParams& params);

  /// Waits for packets at most `timeout`, less when `stop_fd` (an eventfd, or -1) is readable, then takes what has
  /// come and appends the commands that it accepts.
  void service(Time timeout, int stop_fd, std::vector<OperatorCommand>& accepted);
  std::uint32_t count(CommandVerdict verdict) const { return counts_[static_cast<std::size_t>(verdict)].load(); }
  std::uint16_t port() const;

 private:
  UniqueFd socket_;
  CommandDecoder decoder_;
  std::array<std::atomic<std::uint32_t>, kCommandVerdictCount> counts_{};
};

/// Parses "a.b.c.d:port" into a sockaddr_in's parts; false if it is not of that form.
bool parse_endpoint(const std::string& text, std::uint32_t& address_host_order, std::uint16_t& port);

}  // namespace hindsight
