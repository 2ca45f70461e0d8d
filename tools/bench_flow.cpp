// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/bench_flow.h"

#include <time.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "perception/optical_flow.h"
#include "tools/opencv_flow.h"

namespace hindsight::tools {
namespace {

/// Processor time of this thread: all three work on it alone, and what else the machine does stays out of it.
double thread_time_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

double milliseconds(auto&& work) {
  const double begin = thread_time_ms();
  work();
  return thread_time_ms() - begin;
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

struct Ours {
  OpticalFlow flow;
  FlowHistory history;
  std::vector<double> ms;

  Ours(const OpticalFlowParams& flow_params, const FlowHistoryParams& history_params, cv::Size size)
      : flow(flow_params, size.width, size.height), history(history_params, size.width, size.height) {}
  void run(const cv::Mat& bgr) {
    ms.push_back(milliseconds([&] { history.push(flow.update({bgr.data, bgr.total() * bgr.elemSize()})); }));
  }
};

}  // namespace

FlowBench bench_flow(std::span<const cv::Mat> bgr_frames, const OpticalFlowParams& thesis_flow,
                     const FlowHistoryParams& thesis_history, const OpticalFlowParams& default_flow,
                     const FlowHistoryParams& default_history) {
  const cv::Size size = bgr_frames.front().size();
  OpencvFlow opencv(thesis_flow);
  Ours thesis(thesis_flow, thesis_history, size), standard(default_flow, default_history, size);
  std::vector<double> opencv_ms;
  cv::Mat grey;
  for (const cv::Mat& bgr : bgr_frames) {
    cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
    opencv_ms.push_back(milliseconds([&] { opencv.update_grey(grey); }));
    thesis.run(bgr);
    standard.run(bgr);
  }
  for (auto* ms : {&opencv_ms, &thesis.ms, &standard.ms})
    ms->erase(ms->begin());  // the first frame tracks nothing
  return {median(opencv_ms), median(thesis.ms), median(standard.ms)};
}

}  // namespace hindsight::tools
