// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <thread>

#include "daemon/heartbeats.h"

namespace hindsight {

/// Starts a thread of a live run under its name. An exception out of `work` ends that thread alone: it is
/// told, and the heartbeats know, so that the judge stops the vehicle before it ends the process.
std::thread start_beating_thread(ThreadId id, Heartbeats& heartbeats, std::function<void()> work);

}  // namespace hindsight
