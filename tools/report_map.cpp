// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/report_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "tools/activity_picture.h"
#include "tools/report_style.h"
#include "tools/svg_chart.h"

namespace hindsight::tools {
namespace {

constexpr double kMarginM = 3.0;
constexpr double kLeastSideM = 20.0;
constexpr double kGoalNearM = 60.0;
constexpr int kShift = 4;
constexpr Rgb kGoalColor{214, 51, 132};

cv::Point fixed(cv::Point2d px) {
  constexpr double scale = 1 << kShift;
  return {static_cast<int>(std::lround(px.x * scale)), static_cast<int>(std::lround(px.y * scale))};
}

/// A box that grows around points of W.
struct Extent {
  Point2 low{1e9, 1e9};
  Point2 high{-1e9, -1e9};

  void add(Point2 p) {
    low = {std::min(low.x_m, p.x_m), std::min(low.y_m, p.y_m)};
    high = {std::max(high.x_m, p.x_m), std::max(high.y_m, p.y_m)};
  }
  void widen(double& from, double& to) const {
    const double middle = (from + to) / 2, half = std::max((to - from) / 2 + kMarginM, kLeastSideM / 2);
    from = middle - half;
    to = middle + half;
  }
  void finish() {
    widen(low.x_m, high.x_m);
    widen(low.y_m, high.y_m);
  }
};

float sum(const CellEvidence& evidence) { return evidence.votes[0] + evidence.votes[1] + evidence.votes[2]; }

bool is_known(const CellEvidence& evidence) {
  return sum(evidence) > 0.0F || evidence.mark != CellCost::none;
}

Rgb color_of_cell(CellCost cost, const CellEvidence& evidence) {
  if (cost == CellCost::lethal) return kLethal;
  if (cost == CellCost::high) return kBad;
  if (!is_known(evidence)) return kUnknown;
  // The more evidence, the greener.
  const float share = std::min(1.0F, sum(evidence) / 8.0F);
  const auto mix = [share](int from, int to) {
    return static_cast<std::uint8_t>(
        std::lround(static_cast<float>(from) + share * static_cast<float>(to - from)));
  };
  return {mix(223, 129), mix(240, 199), mix(226, 150)};
}

template <typename Visit>
void for_each_cell(const GridWindow& window, Visit&& visit) {
  for (int j = 0; j < window.size_cells; ++j) {
    for (int i = 0; i < window.size_cells; ++i) visit(Cell{window.origin.i + i, window.origin.j + j});
  }
}

Point2 corner_of(Cell cell, double resolution_m) { return {cell.i * resolution_m, cell.j * resolution_m}; }

void draw_cells(cv::Mat& picture, const EvidenceGrid& grid, const MapView& view) {
  const GridWindow& window = grid.window();
  for_each_cell(window, [&](Cell cell) {
    const Rgb color = color_of_cell(grid.cost(cell), grid.evidence(cell));
    if (color == kUnknown) return;
    const cv::Point2d south_west = view.at(corner_of(cell, window.resolution_m));
    const cv::Point2d north_east = view.at(corner_of({cell.i + 1, cell.j + 1}, window.resolution_m));
    const cv::Point from(static_cast<int>(std::lround(south_west.x)),
                         static_cast<int>(std::lround(north_east.y)));
    const cv::Point to(static_cast<int>(std::lround(north_east.x)),
                       static_cast<int>(std::lround(south_west.y)));
    cv::rectangle(picture, cv::Rect(from, cv::Point(std::max(to.x, from.x + 1), std::max(to.y, from.y + 1))),
                  color.bgr(), cv::FILLED);
  });
}

void draw_lines(cv::Mat& picture, const MapView& view, std::span<const Point2> points_W, Rgb color,
                int width_px) {
  for (std::size_t i = 1; i < points_W.size(); ++i) {
    cv::line(picture, fixed(view.at(points_W[i - 1])), fixed(view.at(points_W[i])), color.bgr(), width_px,
             cv::LINE_AA, kShift);
  }
}

void draw_text(cv::Mat& picture, const std::string& text, cv::Point at) {
  cv::putText(picture, text, at, cv::FONT_HERSHEY_SIMPLEX, 0.5, kPaper.bgr(), 4, cv::LINE_AA);
  cv::putText(picture, text, at, cv::FONT_HERSHEY_SIMPLEX, 0.5, kInk.bgr(), 1, cv::LINE_AA);
}

void draw_events(cv::Mat& picture, const MapView& view, std::span<const EventTrace> events) {
  for (const bool contacts : {false, true}) {
    for (const EventTrace& event : events) {
      if (is_contact(event.cause) != contacts) continue;
      const cv::Point at = fixed(view.at(event.p_WP_m));
      const int radius = (contacts ? 6 : 3) << kShift;
      cv::circle(picture, at, radius, color_of(event.cause).bgr(), cv::FILLED, cv::LINE_AA, kShift);
      if (contacts) cv::circle(picture, at, radius, kInk.bgr(), 1, cv::LINE_AA, kShift);
    }
  }
}

Eigen::Matrix3d H_picture_W(const MapView& view) {
  const cv::Point2d origin = view.at({0.0, 0.0});
  Eigen::Matrix3d H;
  H << view.px_per_m(), 0.0, origin.x, 0.0, -view.px_per_m(), origin.y, 0.0, 0.0, 1.0;
  return H;
}

void draw_goal(cv::Mat& picture, const MapView& view, const std::optional<Point2>& goal_W) {
  if (!goal_W) return;
  const cv::Point2d at = view.at(*goal_W);
  cv::drawMarker(picture, {static_cast<int>(std::lround(at.x)), static_cast<int>(std::lround(at.y))},
                 kGoalColor.bgr(), cv::MARKER_TILTED_CROSS, 20, 4, cv::LINE_AA);
}

void draw_robot(cv::Mat& picture, const MapView& view, const Pose2& X_WB, const VehicleParams& vehicle) {
  const double half = vehicle.width_m / 2;
  const std::vector<Point2> corners_B{
      {vehicle.front_m, half}, {vehicle.front_m, -half}, {-vehicle.rear_m, -half}, {-vehicle.rear_m, half}};
  std::vector<cv::Point> body;
  for (const Point2& corner : corners_B) body.push_back(fixed(view.at(X_WB * corner)));
  cv::fillConvexPoly(picture, body, kLeft.bgr(), cv::LINE_AA, kShift);
  cv::polylines(picture, body, true, kInk.bgr(), 1, cv::LINE_AA, kShift);
  const double nose_m = vehicle.front_m + std::max(0.6, 16.0 / view.px_per_m());
  cv::arrowedLine(picture, fixed(view.at(X_WB * Point2{})), fixed(view.at(X_WB * Point2{nose_m, 0.0})),
                  kInk.bgr(), 2, cv::LINE_AA, kShift, 0.3);
}

void draw_scale(cv::Mat& picture, double px_per_m) {
  const double wanted_m = 0.2 * picture.cols / px_per_m;
  const double length_m = axis_marks(0.0, wanted_m, 3).back();
  const int length_px = static_cast<int>(std::lround(length_m * px_per_m));
  const cv::Point from(16, picture.rows - 16);
  cv::rectangle(picture, cv::Rect(from.x, from.y - 5, length_px, 5), kInk.bgr(), cv::FILLED);
  draw_text(picture, fmt::format("{:g} m", length_m), {from.x, from.y - 10});
  const cv::Point north(picture.cols - 24, 48);
  cv::arrowedLine(picture, north, {north.x, 20}, kInk.bgr(), 2, cv::LINE_AA, 0, 0.4);
  draw_text(picture, "N", {north.x - 6, 14});
}

}  // namespace

MapScene scene_of(ReplayRun& run, const RunTrace& trace) {
  Robot& robot = run.robot();
  MapScene scene;
  scene.grid = &robot.grid();
  if (robot.motion() != nullptr) scene.activity = &robot.motion()->map();
  for (const TickTrace& tick : trace.ticks) scene.track_W.push_back({tick.X_WB.x_m, tick.X_WB.y_m});
  scene.path_W.assign(robot.plan().path_W.begin(), robot.plan().path_W.end());
  scene.goal_W = robot.goal_W();
  scene.events = trace.events;
  scene.X_WB = robot.localisation().estimate().X_WB;
  scene.vehicle = run.configuration().vehicle;
  return scene;
}

MapView::MapView(Point2 south_west_W, Point2 north_east_W, double px_per_m)
    : south_west_W_(south_west_W), north_east_W_(north_east_W), px_per_m_(px_per_m) {}

cv::Point2d MapView::at(Point2 p_W) const {
  return {(p_W.x_m - south_west_W_.x_m) * px_per_m_, (north_east_W_.y_m - p_W.y_m) * px_per_m_};
}

cv::Size MapView::size() const {
  return {static_cast<int>(std::ceil((north_east_W_.x_m - south_west_W_.x_m) * px_per_m_)),
          static_cast<int>(std::ceil((north_east_W_.y_m - south_west_W_.y_m) * px_per_m_))};
}

MapView fit_map(const MapScene& scene, int most_px) {
  Extent extent;
  extent.add({scene.X_WB.x_m, scene.X_WB.y_m});
  for (const Point2& p : scene.track_W) extent.add(p);
  for (const EventTrace& event : scene.events) extent.add(event.p_WP_m);
  for_each_cell(scene.grid->window(), [&](Cell cell) {
    if (is_known(scene.grid->evidence(cell))) extent.add(corner_of(cell, scene.grid->window().resolution_m));
  });
  if (scene.goal_W &&
      std::hypot(scene.goal_W->x_m - scene.X_WB.x_m, scene.goal_W->y_m - scene.X_WB.y_m) < kGoalNearM) {
    extent.add(*scene.goal_W);
  }
  extent.finish();
  const double side_m = std::max(extent.high.x_m - extent.low.x_m, extent.high.y_m - extent.low.y_m);
  return {extent.low, extent.high, most_px / side_m};
}

cv::Mat draw_map(const MapScene& scene, const MapView& view) {
  cv::Mat picture(view.size(), CV_8UC3, kUnknown.bgr());
  draw_cells(picture, *scene.grid, view);
  if (scene.activity != nullptr) draw_activity(picture, *scene.activity, H_picture_W(view));
  draw_lines(picture, view, scene.track_W, kInk, 2);
  draw_lines(picture, view, scene.path_W, kRight, 2);
  draw_events(picture, view, scene.events);
  draw_goal(picture, view, scene.goal_W);
  draw_robot(picture, view, scene.X_WB, scene.vehicle);
  draw_scale(picture, view.px_per_m());
  return picture;
}

}  // namespace hindsight::tools
