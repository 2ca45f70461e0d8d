// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <poll.h>

#include <span>

#include "drivers/samples.h"

namespace hindsight {

/// Sleeps until one of `fds` has an event, `stop_fd` (an eventfd, or -1) is readable, or `timeout` has
/// passed, and fills in the `revents`. False on a stop request. Entries with a negative descriptor are left
/// out, as poll(2) does.
bool wait_for(std::span<pollfd> fds, Time timeout, int stop_fd);

/// Sleeps for `timeout`, less on a stop request. False on a stop request.
bool pause_for(Time timeout, int stop_fd);

}  // namespace hindsight
