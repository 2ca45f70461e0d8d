// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/training_events.h"

#include <algorithm>
#include <cmath>

#include "perception/evidence_grid.h"
#include "perception/ground_plane.h"

namespace hindsight {
namespace {

constexpr std::size_t kMaxStrips = 64;
constexpr float kLeastSide_px = 4.0F;  // less is no patch

/// The part of the picture around four points of B; empty where they are behind the camera or out of view.
std::optional<ImageRect> around(const CameraModel& camera,
                                const std::array<Eigen::Vector3d, 4>& corners_B_m) {
  double left = camera.width_px, top = camera.height_px, right = 0.0, bottom = 0.0;
  for (const Eigen::Vector3d& corner : corners_B_m) {
    const auto pixel = camera.project(corner);
    if (!pixel) return std::nullopt;
    left = std::min(left, pixel->x_px + 0.5), right = std::max(right, pixel->x_px + 0.5);
    top = std::min(top, pixel->y_px + 0.5), bottom = std::max(bottom, pixel->y_px + 0.5);
  }
  left = std::floor(std::max(left, 0.0)), right = std::ceil(std::min<double>(right, camera.width_px));
  top = std::floor(std::max(top, 0.0)), bottom = std::ceil(std::min<double>(bottom, camera.height_px));
  const ImageRect rect{static_cast<float>(left), static_cast<float>(top), static_cast<float>(right - left),
                       static_cast<float>(bottom - top)};
  if (rect.width_px < kLeastSide_px || rect.height_px < kLeastSide_px) return std::nullopt;
  return rect;
}

/// An upright rectangle that faces the vehicle.
std::optional<ImageRect> upright_patch(const CameraModel& camera, Point2 p_BP_m, double width_m, double low_m,
                                       double high_m) {
  const double x = p_BP_m.x_m, left = p_BP_m.y_m + width_m / 2, right = p_BP_m.y_m - width_m / 2;
  return around(camera, {{{x, left, high_m}, {x, right, high_m}, {x, left, low_m}, {x, right, low_m}}});
}

/// A rectangle that lies on the ground.
std::optional<ImageRect> ground_patch(const CameraModel& camera, Point2 p_BP_m, double length_m,
                                      double width_m) {
  const double near = p_BP_m.x_m - length_m / 2, far = p_BP_m.x_m + length_m / 2;
  const double left = p_BP_m.y_m + width_m / 2, right = p_BP_m.y_m - width_m / 2;
  return around(camera, {{{near, left, 0}, {near, right, 0}, {far, left, 0}, {far, right, 0}}});
}

/// True at the first of a row of ticks that touch.
bool begins(bool& touching, bool touches) {
  const bool rising = touches && !touching;
  touching = touches;
  return rising;
}

}  // namespace

TrainingEventSource::TrainingEventSource(const TrainingEventParams& params, const CameraModel& camera,
                                         const VehicleParams& vehicle, int history_frames)
    : params_(params),
      camera_(camera),
      vehicle_(vehicle),
      history_frames_(history_frames),
      p_BAhead_m_{vehicle.front_m + params.ahead_m, 0.0} {
  ahead_px_ = by_hand_or(NearPatch::ahead,
                         ground_patch(camera, p_BAhead_m_, params.ahead_length_m, params.ahead_width_m));
  if (const auto& by_hand = camera.patches[static_cast<std::size_t>(NearPatch::ahead)]) {
    const ImagePoint middle{by_hand->x_px + by_hand->width_px / 2 - 0.5,
                            by_hand->y_px + by_hand->height_px / 2 - 0.5};
    p_BAhead_m_ = ground_point(camera, middle).value_or(p_BAhead_m_);
  }
  strips_.reserve(kMaxStrips);
  events_.reserve(kMaxStrips + touching_.size());
}

std::span<const TrainingEvent> TrainingEventSource::update(const TrainingInput& input) {
  events_.clear();
  if (input.new_frame) ++frame_;
  look_at_bumpers(input);
  look_at_ir(input.ir_left_m, true, input.X_WB);
  look_at_ir(input.ir_right_m, false, input.X_WB);
  if (begins(touching_[static_cast<std::size_t>(TrainingCause::slip)], input.slip))
    tell(TrainingCause::slip, TerrainClass::bad, ahead_px_, {vehicle_.front_m, 0.0}, input.X_WB);

  const bool touched = std::any_of(touching_.begin(), touching_.end(), [](bool t) { return t; });
  if (touched) strips_.clear();
  tell_driven_over(input.X_WB);
  if (input.new_frame && !touched) remember_strip(input.X_WB);
  return events_;
}

void TrainingEventSource::clear() {
  strips_.clear();
  last_strip_X_WB_.reset();
}

void TrainingEventSource::tell(TrainingCause cause, TerrainClass label, const std::optional<ImageRect>& patch,
                               Point2 p_BP_m, const Pose2& X_WB) {
  const bool in_view = patch.has_value() && frame_ > 0;
  events_.push_back({cause, label, in_view ? *patch : ImageRect{}, 0, in_view, X_WB * p_BP_m});
}

void TrainingEventSource::look_at_bumpers(const TrainingInput& input) {
  const auto closes = [this](TrainingCause cause, bool pressed) {
    return begins(touching_[static_cast<std::size_t>(cause)], pressed);
  };
  const bool left_closes = closes(TrainingCause::bumper_left, input.bumper_left);
  const bool right_closes = closes(TrainingCause::bumper_right, input.bumper_right);
  if (!left_closes && !right_closes) return;
  const double half_m = vehicle_.width_m / 4;
  if (input.bumper_left && input.bumper_right) {
    tell_bumper(TrainingCause::bumper_both, NearPatch::bumper_both, 0.0, input.X_WB);
  } else if (left_closes) {
    tell_bumper(TrainingCause::bumper_left, NearPatch::bumper_left, half_m, input.X_WB);
  } else {
    tell_bumper(TrainingCause::bumper_right, NearPatch::bumper_right, -half_m, input.X_WB);
  }
}

void TrainingEventSource::tell_bumper(TrainingCause cause, NearPatch by_hand, double side_m,
                                      const Pose2& X_WB) {
  const Point2 p_BP_m{vehicle_.front_m + params_.cone_width_m / 2, side_m};
  const auto top =
      upright_patch(camera_, p_BP_m, params_.cone_width_m, params_.cone_height_m / 2, params_.cone_height_m);
  tell(cause, TerrainClass::lethal, by_hand_or(by_hand, top), p_BP_m, X_WB);
}

void TrainingEventSource::look_at_ir(double range_m, bool left, const Pose2& X_WB) {
  if (std::isnan(range_m)) return;
  const TrainingCause cause = left ? TrainingCause::ir_left : TrainingCause::ir_right;
  bool& touching = touching_[static_cast<std::size_t>(cause)];
  const double threshold_m = params_.ir_threshold_m + (touching ? params_.ir_hysteresis_m : 0.0);
  if (!begins(touching, range_m < threshold_m)) return;
  const double side = left ? 1.0 : -1.0;
  const Point2 p_BP_m{vehicle_.front_m + range_m * std::cos(params_.ir_heading_rad),
                      side * (params_.ir_side_m + range_m * std::sin(params_.ir_heading_rad))};
  const auto spot =
      upright_patch(camera_, p_BP_m, params_.ir_spot_m, params_.ir_height_m - params_.ir_spot_m / 2,
                    params_.ir_height_m + params_.ir_spot_m / 2);
  tell(cause, TerrainClass::bad, by_hand_or(left ? NearPatch::ir_left : NearPatch::ir_right, spot), p_BP_m,
       X_WB);
}

void TrainingEventSource::tell_driven_over(const Pose2& X_WB) {
  std::erase_if(strips_, [&](const Strip& strip) {
    const std::int64_t frames_back = frame_ - strip.frame;
    if (frames_back >= history_frames_) return true;
    const Point2 p_BP_m = X_WB.inverse_times(strip.p_WP_m);
    if (p_BP_m.x_m > 0.0) return false;
    if (std::abs(p_BP_m.y_m) <= vehicle_.width_m / 2)
      events_.push_back({TrainingCause::driven_over, TerrainClass::good, strip.patch_px,
                         static_cast<int>(frames_back), true, strip.p_WP_m});
    return true;
  });
}

void TrainingEventSource::remember_strip(const Pose2& X_WB) {
  if (!ahead_px_) return;
  if (last_strip_X_WB_ &&
      std::hypot(X_WB.x_m - last_strip_X_WB_->x_m, X_WB.y_m - last_strip_X_WB_->y_m) < params_.good_spacing_m)
    return;
  if (strips_.size() == kMaxStrips) strips_.erase(strips_.begin());
  strips_.push_back({frame_, *ahead_px_, X_WB * p_BAhead_m_});
  last_strip_X_WB_ = X_WB;
}

std::optional<ImageRect> TrainingEventSource::by_hand_or(NearPatch patch,
                                                         const std::optional<ImageRect>& computed) const {
  const auto& by_hand = camera_.patches[static_cast<std::size_t>(patch)];
  return by_hand ? by_hand : computed;
}

void mark_event(const TrainingEvent& event, const TrainingEventParams& params, EvidenceGrid& grid) {
  const Cell cell = grid.window().cell_at(event.p_WP_m.x_m, event.p_WP_m.y_m);
  const auto strength = static_cast<float>(params.mark_strength);
  if (event.label == TerrainClass::lethal) grid.mark(cell, CellCost::lethal, EvidenceGrid::kForever);
  if (event.label == TerrainClass::bad) grid.mark(cell, CellCost::high, strength);
  if (event.label == TerrainClass::good) grid.mark(cell, CellCost::none, strength);
}

}  // namespace hindsight
