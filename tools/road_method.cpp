// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/road_method.h"

#include <cmath>
#include <functional>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "config/exit_code.h"
#include "perception/appearance_history.h"
#include "perception/definition_trace.h"
#include "perception/optical_flow.h"
#include "tools/cpu_time.h"
#include "tools/road_baselines.h"

namespace hindsight::tools {
namespace {

std::span<const std::uint8_t> bytes_of(const cv::Mat& frame) {
  return {frame.data, frame.total() * frame.elemSize()};
}

RoadPicture picture_of(const RoadMethodSetup& setup) {
  return {setup.size.width, setup.size.height, setup.configuration.appearance.shrink, setup.horizon_row_px};
}

class FollowerMethod : public RoadMethod {
 public:
  explicit FollowerMethod(const RoadMethodSetup& setup)
      : dt_s_(1.0 / setup.rate_hz),
        size_(setup.size),
        flow_(setup.configuration.flow, size_.width, size_.height),
        history_(setup.configuration.flow_history, size_.width, size_.height),
        appearance_(setup.configuration.appearance, setup.configuration.flow_history.depth + 1, size_.width,
                    size_.height),
        follower_(setup.configuration.road, picture_of(setup), setup.configuration.flow_history.depth) {}

  void see(const cv::Mat& bgr, bool) override {
    const auto vectors = flow_.update(bytes_of(bgr));
    if (appearance_.size() > 0) history_.push(vectors);
    appearance_.push(bytes_of(bgr));
    took_us_ = microseconds([&] { follower_.update({vectors, history_, appearance_, dt_s_}); });
  }
  cv::Mat road() const override { return mask_of(follower_.estimate(), size_); }
  double took_us() const override { return took_us_; }
  bool looks_at_all() const override { return true; }
  const RoadFollower* follower() const override { return &follower_; }

 private:
  double dt_s_;
  cv::Size size_;
  OpticalFlow flow_;
  FlowHistory history_;
  AppearanceHistory appearance_;
  RoadFollower follower_;
  double took_us_ = 0.0;
};

/// A function of single frames; frames that nobody asks for are left out.
class FrameMethod : public RoadMethod {
 public:
  explicit FrameMethod(std::function<cv::Mat(const cv::Mat&)> find) : find_(std::move(find)) {}
  void see(const cv::Mat& bgr, bool wanted) override {
    if (wanted) took_us_ = microseconds([&] { mask_ = find_(bgr); });
  }
  cv::Mat road() const override { return mask_; }
  double took_us() const override { return took_us_; }

 private:
  std::function<cv::Mat(const cv::Mat&)> find_;
  cv::Mat mask_;
  double took_us_ = 0.0;
};

}  // namespace

std::vector<cv::Point> polygon_of(const RoadEstimate& estimate) {
  std::vector<cv::Point> polygon;
  const auto rows = estimate.rows();
  const auto at = [](float x, float y) {
    return cv::Point(static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y)));
  };
  for (const RoadRow& row : rows) polygon.push_back(at(row.left_px, row.row_px));
  for (std::size_t i = rows.size(); i-- > 0;) polygon.push_back(at(rows[i].right_px, rows[i].row_px));
  return polygon;
}

cv::Mat mask_of(const RoadEstimate& estimate, cv::Size size) {
  cv::Mat mask = cv::Mat::zeros(size, CV_8U);
  if (estimate.count >= 2) cv::fillPoly(mask, std::vector{polygon_of(estimate)}, 1);
  return mask;
}

cv::Rect definition_rect(const RoadParams& params, cv::Size size) {
  const RoadStrip strip =
      definition_region(params, {size.width, size.height, 1, std::numeric_limits<double>::quiet_NaN()});
  return {static_cast<int>(strip.left_px), static_cast<int>(strip.top_px), static_cast<int>(strip.width_px()),
          params.definition_height_px};
}

std::unique_ptr<RoadMethod> make_road_follower(const RoadMethodSetup& setup) {
  return std::make_unique<FollowerMethod>(setup);
}

std::unique_ptr<RoadMethod> make_road_baseline(const std::string& name, const RoadMethodSetup& setup) {
  const cv::Rect region = definition_rect(setup.configuration.road, setup.size);
  if (name == "mrf")
    return std::make_unique<FrameMethod>([region](const cv::Mat& bgr) { return mrf_road(bgr, region, 1); });
  if (name == "hsv")
    return std::make_unique<FrameMethod>([region](const cv::Mat& bgr) { return hsv_road(bgr, region); });
  if (name == "texture")
    return std::make_unique<FrameMethod>([region](const cv::Mat& bgr) { return texture_road(bgr, region); });
  throw FatalError(kExitUsage, name + ": no such method");
}

std::unique_ptr<RoadMethod> make_constant_road(const cv::Mat& mask) {
  return std::make_unique<FrameMethod>([mask](const cv::Mat&) { return mask; });
}

}  // namespace hindsight::tools
