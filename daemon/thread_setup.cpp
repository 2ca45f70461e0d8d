// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/thread_setup.h"

#include <pthread.h>
#include <sched.h>

#include <cstring>
#include <string>

#include "daemon/say.h"

namespace hindsight {

void name_this_thread(std::string_view name) {
  pthread_setname_np(pthread_self(), std::string(name.substr(0, 15)).c_str());
}

void make_this_thread_realtime(int priority) {
  if (priority == 0) return;
  sched_param parameters{};
  parameters.sched_priority = priority;
  if (const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters); error != 0) {
    say(Severity::warning, "no real-time priority {}: {}; running with the ordinary one", priority,
        std::strerror(error));
  }
}

}  // namespace hindsight
