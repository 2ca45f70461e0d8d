// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/command_receiver.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <hindsight/command_t.hpp>
#include <set>

#include "config/exit_code.h"
#include "daemon/publisher.h"
#include "daemon/unix_clock.h"

namespace hindsight {
namespace {


CommandParams listening_on(const std::string& listen) {
  CommandParams params;
  params.listen = listen;
  return params;
}
CommandParams on_loopback() { return listening_on("127.0.0.1:0"); }

/// kExitOk where it listens.
ExitCode refusal_of(const CommandParams& params) {
  try {
    CommandReceiver receiver(params);
  } catch (const FatalError& error) {
    return error.code();
  }
  return kExitOk;
}

int option_of(int fd, int option) {
  int value = 0;
  socklen_t size = sizeof value;
  getsockopt(fd, SOL_SOCKET, option, &value, &size);
  return value;
}

std::set<int> sockets_of_this_process() {
  std::set<int> sockets;
  for (int fd = 0; fd < 1024; ++fd) {
    struct stat status {};
    if (fstat(fd, &status) == 0 && S_ISSOCK(status.st_mode)) sockets.insert(fd);
  }
  return sockets;
}

/// Where a stranger's packet can come in: the port of a socket that has one and no fixed peer, else 0.
std::uint16_t open_port_of(int fd) {
  sockaddr_in own{}, peer{};
  socklen_t own_size = sizeof own, peer_size = sizeof peer;
  getsockname(fd, reinterpret_cast<sockaddr*>(&own), &own_size);
  if (own.sin_family != AF_INET || getpeername(fd, reinterpret_cast<sockaddr*>(&peer), &peer_size) == 0)
    return 0;
  return ntohs(own.sin_port);
}

class Sender {
 public:
  explicit Sender(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(port);
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(connect(socket_.get(), reinterpret_cast<const sockaddr*>(&to), sizeof to), 0);
  }
  void send(const std::vector<std::uint8_t>& packet) {
    EXPECT_EQ(::send(socket_.get(), packet.data(), packet.size(), 0), static_cast<ssize_t>(packet.size()));
  }

 private:
  UniqueFd socket_;
};

TEST(CommandReceiver, RefusesWhatItCannotListenOn) {
  for (const char* listen :
       {"", "7668", "127.0.0.1", "127.0.0.1:", "127.0.0.1:70000", "127.0.0.1:7668x", "localhost:1"}) {
    EXPECT_EQ(refusal_of(listening_on(listen)), kExitConfiguration) << listen;
  }
  EXPECT_EQ(refusal_of(listening_on("192.0.2.1:7668")), kExitConfiguration)
      << "a network's address without a key";
  EXPECT_EQ(refusal_of(listening_on("0.0.0.0:7668")), kExitConfiguration) << "any address without a key";
  const CommandReceiver receiver(on_loopback());
  EXPECT_EQ(refusal_of(listening_on("127.0.0.1:" + std::to_string(receiver.port()))), kExitNoDevice)
      << "in use";
}

TEST(CommandReceiver, RefusesAKeyThatOthersMayRead) {
  const std::string file = testing::TempDir() + "hindsight_receiver_key_" + std::to_string(getpid());
  std::ofstream(file) << std::string(64, 'b');
  for (const mode_t mode : {0640U, 0620U, 0610U, 0604U, 0602U, 0601U, 0666U}) {
    chmod(file.c_str(), mode);
    EXPECT_EQ(refusal_of({.listen = "127.0.0.1:0", .key_file = file}), kExitConfiguration)
        << std::oct << mode;
  }
  for (const mode_t mode : {0600U, 0400U}) {
    chmod(file.c_str(), mode);
    EXPECT_EQ(refusal_of({.listen = "127.0.0.1:0", .key_file = file}), kExitOk) << std::oct << mode;
  }
  std::filesystem::remove(file);
}

TEST(CommandReceiver, TakesACommandOnceAndCountsTheRest) {
  CommandReceiver receiver(on_loopback());
  Sender sender(receiver.port());
  const auto packet = encode_command({.kind = CommandKind::arm, .sequence = 1}, unix_now_us(), std::nullopt);
  sender.send(packet);
  sender.send(packet);
  sender.send(std::vector<std::uint8_t>(300, 0x4c));
  sender.send({});
  std::vector<OperatorCommand> accepted;
  receiver.service(from_seconds(1.0), -1, accepted);
  ASSERT_EQ(accepted.size(), 1U);
  EXPECT_EQ(accepted[0].kind, CommandKind::arm);
  EXPECT_EQ(receiver.count(CommandVerdict::replayed), 1U);
  EXPECT_EQ(receiver.count(CommandVerdict::malformed), 2U);
}

TEST(CommandReceiver, AFloodDoesNotKeepItsThread) {
  CommandReceiver receiver(on_loopback());
  Sender sender(receiver.port());
  for (int i = 0; i < 100; ++i) sender.send({1, 2, 3});
  std::vector<OperatorCommand> accepted;
  receiver.service(from_seconds(1.0), -1, accepted);
  EXPECT_GT(receiver.count(CommandVerdict::malformed), 0U);
  EXPECT_LE(receiver.count(CommandVerdict::malformed), 32U) << "the rest waits for the next service";
}

/// Of all that the daemon opens towards a network, only the receiver's socket is read. LCM's has a port since
/// it sends; what comes in there lies in the kernel and is never looked at.
TEST(CommandReceiver, IsAllThatListens) {
  const std::set<int> before = sockets_of_this_process();
  const CommandReceiver receiver(on_loopback());
  Publisher publisher({});
  Outbox outbox;
  outbox.add("HINDSIGHT_TEST", 0, command_t{});
  publisher.publish(outbox, {}, Time(1), 0);
  int receivers = 0;
  for (const int fd : sockets_of_this_process()) {
    if (before.count(fd) != 0) continue;
    EXPECT_EQ(option_of(fd, SO_ACCEPTCONN), 0);
    EXPECT_EQ(option_of(fd, SO_TYPE), SOCK_DGRAM);
    const std::uint16_t port = open_port_of(fd);
    receivers += port == receiver.port();
    if (port == 0 || port == receiver.port()) continue;
    Sender(port).send({1, 2, 3});
    publisher.publish(outbox, {}, Time(2), 0);
    std::uint8_t byte = 0;
    EXPECT_EQ(recv(fd, &byte, 1, MSG_PEEK | MSG_DONTWAIT), 1) << "somebody has read it";
  }
  EXPECT_EQ(receivers, 1);
}

}  // namespace
}  // namespace hindsight
