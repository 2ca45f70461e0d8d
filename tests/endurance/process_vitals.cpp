// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "process_vitals.h"

#include <malloc.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace hindsight::endurance {
namespace {

int entries(const char* folder) {
  const std::filesystem::directory_iterator begin(folder);
  return static_cast<int>(std::distance(begin, std::filesystem::directory_iterator()));
}

}  // namespace

ProcessVitals process_vitals() {
  long pages = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> pages >> resident;
  ProcessVitals vitals;
  const struct mallinfo2 heap = mallinfo2();
  vitals.heap_mb = static_cast<double>(heap.uordblks + heap.hblkhd) / 1e6;
  vitals.resident_mb = static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
  vitals.descriptors = entries("/proc/self/fd") - 1;  // less the one that counts
  vitals.threads = entries("/proc/self/task");
  return vitals;
}

}  // namespace hindsight::endurance
