// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/navigation_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "tools/report_style.h"
#include "tools/statistics.h"

namespace hindsight::tools {
namespace {

constexpr double kPxPerM = 8.0;
constexpr double kMargin_m = 4.0;
const cv::Size kPlot(820, 520);
const cv::Rect kAxes(80, 40, 700, 400);

cv::Scalar color_of_arm(std::size_t arm) {
  return arm == 0 ? kLethal.bgr() : arm == 1 ? kLeft.bgr() : kRight.bgr();
}

void text(cv::Mat& picture, const std::string& words, cv::Point at, double size = 0.5) {
  cv::putText(picture, words, at, cv::FONT_HERSHEY_SIMPLEX, size, kInk.bgr(), 1, cv::LINE_AA);
}

/// East is to the right, north is up.
struct Panel {
  double west_m, north_m;
  cv::Mat picture;

  cv::Point at(WorldPoint p) const {
    return {static_cast<int>(std::lround((p.x_m - west_m) * kPxPerM)),
            static_cast<int>(std::lround((north_m - p.y_m) * kPxPerM))};
  }
};

Panel empty_panel(const World& world) {
  const double west = std::min(world.start.x_m, world.goal.x_m) - 2 * kMargin_m,
               east = std::max(world.start.x_m, world.goal.x_m) + kMargin_m;
  double north = 10.0;
  for (const Tree& tree : world.trees) north = std::max(north, std::abs(tree.at.y_m));
  north = std::min(north, 18.0);
  return {west, north,
          cv::Mat(static_cast<int>(2 * north * kPxPerM), static_cast<int>((east - west) * kPxPerM), CV_8UC3,
                  kPaper.bgr())};
}

cv::Mat draw_world(const World& world, const std::string& arm, std::size_t arm_number,
                   const std::vector<NavigationRun>& runs) {
  Panel panel = empty_panel(world);
  for (const Tree& tree : world.trees)
    cv::circle(panel.picture, panel.at(tree.at), std::max(2, static_cast<int>(tree.radius_m * kPxPerM)),
               cv::Scalar(60, 110, 60), cv::FILLED, cv::LINE_AA);
  for (const NavigationRun& run : runs) {
    if (run.arm != arm || run.world_seed != world.seed) continue;
    for (std::size_t i = 1; i < run.path.size(); ++i)
      cv::line(panel.picture, panel.at(run.path[i - 1]), panel.at(run.path[i]), color_of_arm(arm_number), 1,
               cv::LINE_AA);
  }
  cv::drawMarker(panel.picture, panel.at(world.goal), kInk.bgr(), cv::MARKER_TILTED_CROSS, 14, 3,
                 cv::LINE_AA);
  text(panel.picture, fmt::format("{}, world {}", arm, world.seed), {8, 18});
  cv::rectangle(panel.picture, {{0, 0}, panel.picture.size()}, kInk.bgr());
  return panel.picture;
}

struct Scale {
  double most_seconds, most_touches;
  cv::Point2d at(double seconds, double touches) const {
    return {kAxes.x + seconds / most_seconds * kAxes.width,
            kAxes.y + kAxes.height - touches / most_touches * kAxes.height};
  }
};

void draw_axes(cv::Mat& picture, const Scale& scale) {
  cv::rectangle(picture, kAxes, kInk.bgr());
  for (int i = 0; i <= 5; ++i) {
    const double seconds = scale.most_seconds * i / 5, touches = scale.most_touches * i / 5;
    text(picture, fmt::format("{:.0f}", seconds), cv::Point(scale.at(seconds, 0)) + cv::Point(-12, 22));
    text(picture, fmt::format("{:.1f}", touches), cv::Point(scale.at(0, touches)) + cv::Point(-42, 5));
  }
  text(picture, "time to the goal [s]", {kAxes.x + kAxes.width / 2 - 80, kAxes.y + kAxes.height + 50});
  text(picture, "touches a run", {10, 24});
}

void draw_ellipse(cv::Mat& picture, const Scale& scale, const Ellipse& e, const cv::Scalar& color) {
  std::vector<cv::Point> outline;
  for (int i = 0; i < 72; ++i) {
    const double t = 2 * std::numbers::pi * i / 72, u = e.major * std::cos(t), v = e.minor * std::sin(t);
    outline.emplace_back(scale.at(e.x + u * std::cos(e.angle_rad) - v * std::sin(e.angle_rad),
                                  e.y + u * std::sin(e.angle_rad) + v * std::cos(e.angle_rad)));
  }
  cv::polylines(picture, outline, true, color, 2, cv::LINE_AA);
}

}  // namespace

cv::Mat draw_paths(const std::vector<World>& worlds, const std::vector<std::string>& arms,
                   const std::vector<NavigationRun>& runs) {
  std::vector<cv::Mat> rows;
  for (const World& world : worlds) {
    std::vector<cv::Mat> panels;
    for (std::size_t a = 0; a < arms.size(); ++a) panels.push_back(draw_world(world, arms[a], a, runs));
    cv::Mat row;
    cv::hconcat(panels, row);
    rows.push_back(row);
  }
  int width = 0;
  for (const cv::Mat& row : rows) width = std::max(width, row.cols);
  for (cv::Mat& row : rows)
    cv::copyMakeBorder(row, row, 0, 0, 0, width - row.cols, cv::BORDER_CONSTANT, kPaper.bgr());
  cv::Mat all;
  cv::vconcat(rows, all);
  return all;
}

cv::Mat draw_ellipses(const std::vector<std::string>& arms, const std::vector<NavigationRun>& runs) {
  cv::Mat picture(kPlot, CV_8UC3, kPaper.bgr());
  Scale scale{60.0, 2.0};
  for (const NavigationRun& run : runs) {
    scale.most_seconds = std::max(scale.most_seconds, 1.1 * run.seconds);
    scale.most_touches = std::max(scale.most_touches, 1.2 * run.all_touches());
  }
  draw_axes(picture, scale);
  cv::Mat plot = picture;
  for (std::size_t a = 0; a < arms.size(); ++a) {
    std::vector<double> seconds, touches;
    for (const NavigationRun& run : runs) {
      if (run.arm != arms[a]) continue;
      seconds.push_back(run.seconds);
      touches.push_back(run.all_touches());
      cv::circle(plot, scale.at(run.seconds, run.all_touches()), 4, color_of_arm(a),
                 run.reached ? cv::FILLED : 1, cv::LINE_AA);
    }
    draw_ellipse(plot, scale, ellipse_95(seconds, touches), color_of_arm(a));
    const cv::Point key(kAxes.x + 12, kAxes.y + 20 + 20 * static_cast<int>(a));
    cv::circle(plot, key, 4, color_of_arm(a), cv::FILLED, cv::LINE_AA);
    text(plot, arms[a] + (a == 0 ? "  (hollow: goal not reached)" : ""), key + cv::Point(10, 5));
  }
  return picture;
}

}  // namespace hindsight::tools
