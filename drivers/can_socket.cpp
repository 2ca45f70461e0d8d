// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "drivers/can_socket.h"

#include <linux/can.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <sys/socket.h>

#include <vector>

namespace hindsight {
namespace {

// The kernel raises this to its least, which holds a handful of CAN frames.
constexpr int kLeastSendBuffer = 1;

template <class Value>
bool set_option(int fd, int level, int option, const Value& value) {
  return ::setsockopt(fd, level, option, &value, sizeof(value)) == 0;
}

bool set_filters(int fd, std::span<const std::uint32_t> ids) {
  std::vector<can_filter> filters;
  for (const std::uint32_t id : ids) {
    const std::uint32_t id_mask = (id & CAN_EFF_FLAG) != 0 ? CAN_EFF_MASK : CAN_SFF_MASK;
    filters.push_back({.can_id = id, .can_mask = id_mask | CAN_EFF_FLAG | CAN_RTR_FLAG});
  }
  return ::setsockopt(fd, SOL_CAN_RAW, CAN_RAW_FILTER, filters.data(),
                      static_cast<socklen_t>(filters.size() * sizeof(can_filter))) == 0;
}

/// Binds after all options are set, so that nothing unwanted comes in between. An errno, or 0.
int bind_to(int fd, const std::string& interface) {
  sockaddr_can address{};
  address.can_family = AF_CAN;
  address.can_ifindex = static_cast<int>(::if_nametoindex(interface.c_str()));
  if (address.can_ifindex == 0) return ENODEV;
  // A union of address types is what the sockets interface is.
  if (::bind(fd, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0) return errno;
  int pending = 0;  // the kernel tells in this way that the interface is down
  socklen_t length = sizeof(pending);
  return ::getsockopt(fd, SOL_SOCKET, SO_ERROR, &pending, &length) == 0 ? pending : errno;
}

UniqueFd open_raw(const std::string& interface, DeviceError& error) {
  UniqueFd fd(::socket(PF_CAN, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, CAN_RAW));
  if (!fd) error = DeviceError::from_errno(errno, interface, "no CAN socket");
  return fd;
}

UniqueFd finish(UniqueFd fd, bool options_set, const std::string& interface, DeviceError& error) {
  if (!options_set) {
    error = DeviceError::from_errno(errno, interface, "a CAN socket option is refused");
    return {};
  }
  if (const int code = bind_to(fd.get(), interface); code != 0) {
    error = DeviceError::from_errno(code, interface, "CAN interface cannot be used");
    return {};
  }
  return fd;
}

}  // namespace

UniqueFd open_can_receiver(const std::string& interface, std::span<const std::uint32_t> ids,
                           DeviceError& error) {
  UniqueFd fd = open_raw(interface, error);
  if (!fd) return fd;
  const can_err_mask_t all_errors = CAN_ERR_MASK;
  const bool options_set =
      set_filters(fd.get(), ids) && set_option(fd.get(), SOL_CAN_RAW, CAN_RAW_ERR_FILTER, all_errors) &&
      set_option(fd.get(), SOL_SOCKET, SO_TIMESTAMPNS, 1) && set_option(fd.get(), SOL_SOCKET, SO_RXQ_OVFL, 1);
  return finish(std::move(fd), options_set, interface, error);
}

UniqueFd open_can_sender(const std::string& interface, DeviceError& error) {
  UniqueFd fd = open_raw(interface, error);
  if (!fd) return fd;
  const bool options_set =
      set_filters(fd.get(), {}) && set_option(fd.get(), SOL_SOCKET, SO_SNDBUF, kLeastSendBuffer);
  return finish(std::move(fd), options_set, interface, error);
}

}  // namespace hindsight
