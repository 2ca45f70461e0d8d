// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace hindsight {

/// Exit codes of both programs: those of sysexits.h, which systemd names; 1 is "the answer is no" (verify).
enum ExitCode : int {
  kExitOk = 0,
  kExitDiffers = 1,
  kExitUsage = 64,
  kExitBadData = 65,      ///< a log, picture, calibration or CSV that is damaged or does not fit
  kExitNoInput = 66,      ///< a file or folder that is not there or cannot be read
  kExitNoDevice = 69,     ///< a device or bus that is absent or busy
  kExitSoftware = 70,     ///< our own fault
  kExitIo = 74,           ///< writing failed
  kExitConfiguration = 78
};

/// An error that ends the program with the exit code given. The message names the file and the place in it and says
/// what was expected. Thrown at start-up and by tools, never by a running loop.
class FatalError : public std::runtime_error {
 public:
  FatalError(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

}  // namespace hindsight
