// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The world's end of the robot's GPS: says the simulated fixes in gpsd's JSON protocol, where the robot looks
// for gpsd.
#pragma once

#include <span>
#include <vector>

#include "drivers/gpsd_client.h"
#include "drivers/unique_fd.h"

namespace hindsight::tools {

/// Never blocks. One thread.
class GpsdServer {
 public:
  /// Listens on params.host and port. FatalError(kExitNoDevice) where that is taken: gpsd itself runs there?
  explicit GpsdServer(const GpsParams& params);

  /// Lets in who waits and tells all of them the fixes; who does not read is dropped.
  void serve(std::span<const GpsFix> fixes);

 private:
  UniqueFd listener_;
  std::vector<UniqueFd> clients_;
};

}  // namespace hindsight::tools
