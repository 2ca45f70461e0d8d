// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "drivers/samples.h"
#include "sim_replay/track_csv.h"

namespace hindsight {

/// The vehicle's CAN frames for one row of a track: wheel speeds, motor currents, IR ranges and yaw rate,
/// whichever the row has. The other columns are not its business.
class TrackEncoder {
 public:
  virtual ~TrackEncoder() = default;
  /// Adds the row's frames, all with this stamp; none where the row has nothing for the bus.
  virtual void encode(const TrackRow& row, Time stamp, std::vector<CanFrame>& frames) = 0;
  /// Text of the DBC file by which it encodes, for the log's header.
  virtual std::string dbc() const = 0;
};

struct ImportOptions {
  std::filesystem::path frames;  ///< folder of numbered pictures, or a video file
  double rate_hz = 0.0;          ///< of the frames; the first is at time 0
  std::filesystem::path camera;  ///< calibration, OpenCV's or ROS's YAML with image_width and image_height
  std::filesystem::path track;   ///< CSV (track_csv.h); empty: none
  std::filesystem::path output;
  std::string build_id;
};

struct ImportSummary {
  std::uint64_t frames = 0;
  std::uint64_t rows = 0;
  std::uint64_t can_frames = 0;
  std::uint64_t edges = 0;
  std::uint64_t fixes = 0;
  std::uint64_t commands = 0;
  double duration_s = 0.0;  ///< from the first to the last sample
  std::uint64_t bytes = 0;
};

/// Called after every frame: how many are done, and of how many (0 where a video does not tell).
using ImportProgress = std::function<void(std::uint64_t done, std::uint64_t total)>;

/// Makes a run log without ticks from pictures and a track, in the order of time. The first sample's stamp is
/// one second; event times are the stamps. Of a level only changes become edges, the first value included; of
/// goal and arm only changes become commands. Throws FatalError: 66 what is absent, 65 what does not fit, 74
/// what cannot be written; the unfinished log is removed then.
ImportSummary import_recording(const ImportOptions& options, TrackEncoder& encoder,
                               const ImportProgress& progress);

}  // namespace hindsight
