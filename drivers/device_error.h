// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cerrno>
#include <cstring>
#include <string>

namespace hindsight {

/// Why a device could not be opened: the errno and a sentence for a person that names the device. At start it
/// becomes a FatalError(kExitNoDevice); in the running loop only its code travels on, in a SourceReport.
struct DeviceError {
  int code = 0;
  std::string message;

  /// "<device>: <what>: <the errno's text>"
  static DeviceError from_errno(int code, const std::string& device, const std::string& what) {
    return {code, device + ": " + what + ": " + std::strerror(code)};
  }
};

}  // namespace hindsight
