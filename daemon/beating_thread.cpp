// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/beating_thread.h"

#include <exception>
#include <utility>

#include "daemon/say.h"
#include "daemon/thread_setup.h"

namespace hindsight {

std::thread start_beating_thread(ThreadId id, Heartbeats& heartbeats, std::function<void()> work) {
  return std::thread([id, &heartbeats, work = std::move(work)] {
    name_this_thread(name_of(id));
    try {
      work();
    } catch (const std::exception& error) {
      heartbeats.die(id);  // first: telling may take its time
      say(Severity::error, "thread {} died: {}", name_of(id), error.what());
    }
  });
}

}  // namespace hindsight
