// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "drivers/device_error.h"
#include "drivers/unique_fd.h"

namespace hindsight {

/// A non-blocking raw CAN socket that receives the identifiers given and error frames, with receive time
/// stamps and the count of overflows. Empty on failure, with `error` filled in; an interface that is down is
/// a failure (ENETDOWN).
UniqueFd open_can_receiver(const std::string& interface, std::span<const std::uint32_t> ids,
                           DeviceError& error);

/// The same for sending: receives nothing, and queues only a few frames, so that no old command waits behind
/// a bus that is stuck.
UniqueFd open_can_sender(const std::string& interface, DeviceError& error);

}  // namespace hindsight
