// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

namespace hindsight::endurance {

/// What a process that runs for weeks must not use up.
struct ProcessVitals {
  double heap_mb = 0.0;      ///< allocated and not freed
  double resident_mb = 0.0;  ///< with what the allocator keeps for later
  int descriptors = 0;
  int threads = 0;
};

/// Of this process, from glibc's allocator and /proc.
ProcessVitals process_vitals();

}  // namespace hindsight::endurance
