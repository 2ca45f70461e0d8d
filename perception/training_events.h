// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What near-range sensors teach: which patch of which frame is good, bad or lethal (thesis 5.1, "training
// events").
//
// A bumper that closes: the top of a traffic cone that touches its half of the bumper is lethal; where both
// halves are pressed, of one that touches the middle. An IR sensor below its range threshold: the spot that
// it measures is bad. Slip: the ground just ahead is bad. Ground that was seen ahead and is then driven over
// without any of these is good: a strip of ground is remembered every good_spacing_m, with the frame that
// shows it, and taught once odometry says that the driven axle has crossed it.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "config/params.h"
#include "config/vehicle_params.h"
#include "perception/camera_model.h"
#include "perception/pose.h"
#include "perception/terrain_class.h"

namespace hindsight {

class EvidenceGrid;

struct TrainingEventParams {
  double cone_height_m = 0.7;
  double cone_width_m = 0.2;
  double ir_threshold_m = 0.6;
  double ir_hysteresis_m = 0.2;
  double ir_side_m = 0.25;
  double ir_height_m = 0.4;
  double ir_heading_rad = 0.0;
  double ir_spot_m = 0.25;
  double ahead_m = 1.0;
  double ahead_length_m = 0.5;
  double ahead_width_m = 0.6;
  double good_spacing_m = 1.0;
  double mark_strength = 300.0;

  void visit(auto&& param) {
    param("cone_height_m", cone_height_m, Range{0.1, 3.0},
          "height of what a bumper touches; its upper half trains [m]");
    param("cone_width_m", cone_width_m, Range{0.02, 2.0}, "width of what a bumper touches [m]");
    param("ir_threshold_m", ir_threshold_m, Range{0.05, 10.0},
          "range from the bumper below which IR has met something [m]");
    param("ir_hysteresis_m", ir_hysteresis_m, Range{0.0, 5.0},
          "so much farther, and IR is ready for the next thing [m]");
    param("ir_side_m", ir_side_m, Range{0.0, 2.0}, "IR sensors' distance from the vehicle's middle [m]");
    param("ir_height_m", ir_height_m, Range{0.0, 2.0}, "IR sensors' height [m]");
    param("ir_heading_rad", ir_heading_rad, Range{-1.6, 1.6}, "how far IR sensors look outwards [rad]");
    param("ir_spot_m", ir_spot_m, Range{0.02, 2.0}, "side of the spot that IR means [m]");
    param("ahead_m", ahead_m, Range{0.0, 10.0},
          "from the bumper to the middle of a strip of ground ahead [m]");
    param("ahead_length_m", ahead_length_m, Range{0.05, 5.0}, "length of a strip of ground [m]");
    param("ahead_width_m", ahead_width_m, Range{0.05, 5.0}, "width of a strip of ground [m]");
    param("good_spacing_m", good_spacing_m, Range{0.1, 100.0},
          "drive between two strips that may teach good [m]");
    param("mark_strength", mark_strength, Range{0.0, 1e6},
          "good votes that wear off an IR or slip mark in the grid, or that driving over a cell is worth");
  }
};

enum class TrainingCause : std::uint8_t {
  bumper_left = 0,
  bumper_right = 1,
  ir_left = 2,
  ir_right = 3,
  slip = 4,
  driven_over = 5,
  bumper_both = 6
};
constexpr int kTrainingCauseCount = 7;

struct TrainingEvent {
  TrainingCause cause = TrainingCause::bumper_left;
  TerrainClass label = TerrainClass::lethal;
  ImageRect patch_px;    ///< clipped to the picture; empty where not in view
  int frames_back = 0;   ///< the frame in which patch_px holds; 0 is the newest
  bool in_view = false;  ///< false: nothing to train on, but the ground is to be marked
  Point2 p_WP_m;         ///< where on the ground
};

/// One tick's near-range sensing.
struct TrainingInput {
  Pose2 X_WB;
  bool new_frame = false;    ///< a frame was pushed to the histories in this tick
  bool bumper_left = false;  ///< pressed now or at any time since the last tick
  bool bumper_right = false;
  /// From the bumper to what the sensor sees; NaN: unknown, which changes nothing; infinite: nothing there.
  double ir_left_m = std::numeric_limits<double>::quiet_NaN();
  double ir_right_m = std::numeric_limits<double>::quiet_NaN();
  bool slip = false;
};

/// One event a contact: a sensor must let go before it can tell again. One thread.
class TrainingEventSource {
 public:
  /// history_frames: frames that the appearance history holds; strips seen earlier are given up.
  TrainingEventSource(const TrainingEventParams& params, const CameraModel& camera,
                      const VehicleParams& vehicle, int history_frames);

  /// The events of this tick, contacts first, valid until the next call. No allocation.
  std::span<const TrainingEvent> update(const TrainingInput& input);

  /// Forgets remembered strips: the stream of frames or the pose was interrupted.
  void clear();

 private:
  struct Strip {
    std::int64_t frame = 0;
    ImageRect patch_px;
    Point2 p_WP_m;
  };

  void tell(TrainingCause cause, TerrainClass label, const std::optional<ImageRect>& patch, Point2 p_BP_m,
            const Pose2& X_WB);
  void look_at_bumpers(const TrainingInput& input);
  /// side_m: of the touched thing's middle, left positive.
  void tell_bumper(TrainingCause cause, NearPatch by_hand, double side_m, const Pose2& X_WB);
  void look_at_ir(double range_m, bool left, const Pose2& X_WB);
  void tell_driven_over(const Pose2& X_WB);
  void remember_strip(const Pose2& X_WB);
  std::optional<ImageRect> by_hand_or(NearPatch patch, const std::optional<ImageRect>& computed) const;

  TrainingEventParams params_;
  CameraModel camera_;
  VehicleParams vehicle_;
  int history_frames_;
  std::optional<ImageRect> ahead_px_;
  Point2 p_BAhead_m_;
  std::int64_t frame_ = 0;          ///< frames so far
  std::array<bool, 5> touching_{};  ///< by cause
  std::optional<Pose2> last_strip_X_WB_;
  std::vector<Strip> strips_;  ///< oldest first
  std::vector<TrainingEvent> events_;
};

/// Writes an event to the grid: lethal for ever at a bumper hit, high at IR and slip, good votes where driven
/// over.
void mark_event(const TrainingEvent& event, const TrainingEventParams& params, EvidenceGrid& grid);

}  // namespace hindsight
