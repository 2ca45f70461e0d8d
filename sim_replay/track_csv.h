// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hindsight {

/// One row of a track: what the sensors other than the camera said at one time. A value is absent where its
/// cell is empty or its column missing.
struct TrackRow {
  using Cell = std::optional<double>;
  double time_s = 0.0;               ///< of the recording; the first frame is at 0
  Cell left_mps, right_mps;          ///< wheel speeds
  Cell left_a, right_a;              ///< motor currents
  Cell ir_left_m, ir_right_m;        ///< IR ranges
  Cell yaw_rate_radps;               ///< about the body's z axis, positive to the left
  Cell bumper_left, bumper_right;    ///< levels: 1 pressed, 0 not
  Cell estop;                        ///< level: 1 pressed, 0 not
  Cell latitude_deg, longitude_deg;  ///< GPS fix, WGS84
  Cell goal_east_m, goal_north_m;    ///< the operator says: go there (W)
  Cell arm;                          ///< 1: the operator arms; 0 after 1: disarms
};

/// Reads a track CSV line by line. The first line names the columns, in any order: `time_s`, which must be
/// there, and any of those of TrackRow. Cells may be empty. Empty lines and lines that begin with # are
/// skipped. Throws FatalError 66 where the file is absent; 65 with file:line:column where a column is unknown
/// or named twice, a line has another number of cells than the first, a cell is no finite number, a level is
/// neither 0 nor 1, half of a position is missing, or time goes backwards.
class TrackCsv {
 public:
  explicit TrackCsv(const std::filesystem::path& path);
  /// False at the end.
  bool next(TrackRow& row);

 private:
  bool next_line();
  void read_columns();
  void set_cell(TrackRow& row, std::size_t column, std::string_view text) const;
  void check(const TrackRow& row) const;
  [[noreturn]] void fail(std::string_view column, std::string_view reason) const;

  std::string path_;
  std::ifstream file_;
  std::string line_;
  std::uint64_t line_number_ = 0;
  std::vector<std::size_t>
      columns_;  ///< of each cell of a line, the number of its column in the table of all
  std::optional<double> last_time_s_;
};

}  // namespace hindsight
