// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The drivers on real kernel interfaces, with the faults that the kernel's fake hardware can make. They
// change the machine's devices, so they run only where HINDSIGHT_DESK is set: as root in the user-mode Linux
// of tests/desk, with vivid at /dev/video0, v4l2loopback at /dev/video10, vcan, and gpio-sim through
// configfs.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <string>

#include "drivers/monotonic_clock.h"
#include "recording_sink.h"

namespace hindsight {

using std::chrono::milliseconds;

class OnDevice : public testing::Test {
 protected:
  void SetUp() override {
    if (std::getenv("HINDSIGHT_DESK") == nullptr) GTEST_SKIP() << "HINDSIGHT_DESK is not set";
  }
  /// Serves the driver until `done`, at most for `limit`; says whether it got there.
  template <class Driver>
  bool serve(Driver& driver, std::function<bool()> done, Time limit = milliseconds(4000)) {
    const Time end = monotonic_now() + limit;
    while (!done() && monotonic_now() < end) driver.service(milliseconds(20));
    return done();
  }
  RecordingSink sink_;
};

inline bool run(const std::string& command) { return std::system(command.c_str()) == 0; }

}  // namespace hindsight
