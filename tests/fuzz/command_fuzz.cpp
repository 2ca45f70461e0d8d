// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Datagrams to the command receiver's own socket, one after the other: first byte the length, then so many
// bytes.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <cmath>
#include <memory>
#include <vector>

#include "daemon/command_receiver.h"
#include "fuzz.h"

namespace hindsight::fuzz {
namespace {

/// A window that takes every time that a seed may name: only the sequence numbers then stand against a
/// replay.
constexpr double kWindow_s = 4e9;

class Line {
 public:
  explicit Line(const std::string& key_file)
      : receiver_({.listen = "127.0.0.1:0", .key_file = key_file, .window_s = kWindow_s}),
        sender_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(receiver_.port());
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    require(connect(sender_.get(), reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0,
            "the receiver is there");
  }

  std::vector<OperatorCommand> send_all(Bytes datagrams) {
    std::vector<OperatorCommand> accepted;
    for (Reader in(datagrams); !in.empty();) {
      const Bytes packet = in.take(in.take<std::uint8_t>());
      if (send(sender_.get(), packet.data(), packet.size(), 0) < 0) continue;
      receiver_.service(from_seconds(1.0), -1, accepted);
    }
    return accepted;
  }

 private:
  CommandReceiver receiver_;
  UniqueFd sender_;
};

/// Any key will do: what passes under it is a forgery.
std::string key_file() {
  static MemoryFile file;
  const std::string digits(64, 'a');
  const std::string& path =
      file.holding({reinterpret_cast<const std::uint8_t*>(digits.data()), digits.size()});
  chmod(path.c_str(), 0600);
  return path;
}

void run(Bytes bytes) {
  static const std::string key = key_file();
  std::int64_t last = 0;
  for (const OperatorCommand& command : Line("").send_all(bytes)) {
    const bool stop = command.kind == CommandKind::stop;  // which is obeyed whenever it comes
    require(stop || command.sequence > last, "no sequence number is taken twice");
    require(command.kind <= CommandKind::save_model, "the kind is known");
    require(std::isfinite(command.a) && std::isfinite(command.b), "numbers are finite");
    if (!stop) last = command.sequence;
  }
  require(Line(key).send_all(bytes).empty(), "nothing passes without the key");
}

}  // namespace
}  // namespace hindsight::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  hindsight::fuzz::run({data, size});
  return 0;
}
