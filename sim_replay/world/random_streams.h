// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

namespace hindsight {

/// Purposes of Random in building a world: what draws more from one stream leaves the others alone.
enum WorldStream : std::uint64_t {
  lane_stream = 1,
  terrain_stream,
  fence_stream,
  mud_stream,
  objects_stream
};

}  // namespace hindsight
