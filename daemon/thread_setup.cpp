// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/thread_setup.h"

#include <malloc.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <limits>
#include <string>

#include "daemon/say.h"

namespace hindsight {

void name_this_thread(std::string_view name) {
  pthread_setname_np(pthread_self(), std::string(name.substr(0, 15)).c_str());
}

void keep_this_thread_on(int cpu) {
  if (cpu < 0) return;
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(static_cast<std::size_t>(cpu), &set);
  if (const int error = pthread_setaffinity_np(pthread_self(), sizeof set, &set); error != 0) {
    say(Severity::warning, "cannot stay on processor {}: {}; running on any", cpu, std::strerror(error));
  }
}

void lock_memory() {
  // Under a limit, locking would make later allocations fail: all or nothing.
  const rlimit all{RLIM_INFINITY, RLIM_INFINITY};
  if (setrlimit(RLIMIT_MEMLOCK, &all) != 0 || mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) != 0) {
    say(Severity::warning, "memory is not locked: {}; it may be swapped out (LimitMEMLOCK=infinity permits it)",
        std::strerror(errno));
    return;
  }
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());  // what was freed stays for the next allocation
}

void touch_stack() {
  constexpr std::size_t kBytes = 256 * 1024;
  constexpr std::size_t kPage = 4096;
  std::array<volatile char, kBytes> stack;
  for (std::size_t i = 0; i < kBytes; i += kPage) stack[i] = 0;
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
