// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "drivers/wait.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace hindsight {

bool wait_for(std::span<pollfd> fds, Time timeout, int stop_fd) {
  constexpr std::size_t kMost = 8;
  std::array<pollfd, kMost + 1> all{};
  assert(fds.size() <= kMost);
  const std::size_t count = fds.size();
  std::copy_n(fds.begin(), count, all.begin());
  all[count] = {.fd = stop_fd, .events = POLLIN, .revents = 0};
  const std::int64_t ns = std::max<std::int64_t>(timeout.count(), 0);
  const timespec limit{.tv_sec = ns / 1'000'000'000, .tv_nsec = ns % 1'000'000'000};
  if (ppoll(all.data(), count + 1, &limit, nullptr) < 0) {
    for (pollfd& each : all) each.revents = 0;  // a signal: as if the time were up
  }
  std::copy_n(all.begin(), count, fds.begin());
  return all[count].revents == 0;
}

bool pause_for(Time timeout, int stop_fd) { return wait_for({}, timeout, stop_fd); }

}  // namespace hindsight
