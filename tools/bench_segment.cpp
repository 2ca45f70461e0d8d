// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/bench_segment.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <ctime>
#include <opencv2/ml.hpp>
#include <vector>

#include "perception/segmenter.h"

namespace hindsight::tools {
namespace {

constexpr int kRounds = 3;
constexpr int kEmTraining_px = 4000;
constexpr int kEmSample_px = 3000;

std::span<const std::uint8_t> bytes_of(const cv::Mat& frame) {
  return {frame.data, frame.total() * frame.elemSize()};
}

/// Of this thread's processor time, which other programs' load does not count into.
double now_ms() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

template <typename Work>
double milliseconds(Work&& work) {
  const double begin = now_ms();
  work();
  return now_ms() - begin;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The pixels of a patch as wide and high as the given share of the frame, in its lower middle or at its
/// left.
std::vector<std::array<std::uint8_t, 3>> patch(const cv::Mat& frame, double centre_x, double centre_y) {
  const int half_w = frame.cols / 30, half_h = frame.rows / 30;
  const int x0 = static_cast<int>(centre_x * frame.cols), y0 = static_cast<int>(centre_y * frame.rows);
  std::vector<std::array<std::uint8_t, 3>> pixels;
  for (int y = y0 - half_h; y < y0 + half_h; ++y) {
    for (int x = x0 - half_w; x < x0 + half_w; ++x) {
      const auto c = frame.at<cv::Vec3b>(y, x);
      pixels.push_back({c[0], c[1], c[2]});
    }
  }
  return pixels;
}

/// Ground in front is good, what stands at the left is lethal: one event of each in turn.
void train_once(TerrainMixture& mixture, const cv::Mat& frame, std::size_t turn) {
  if (turn % 4 == 3) {
    mixture.train(patch(frame, 0.1, 0.5), TerrainClass::lethal);
  } else {
    mixture.train(patch(frame, 0.5, 0.8), TerrainClass::good);
  }
}

cv::Mat pixels_as_rows(const cv::Mat& frame, int count) {
  cv::Mat rows(count, 3, CV_64F);
  const std::size_t step = frame.total() / static_cast<std::size_t>(count);
  for (int i = 0; i < count; ++i) {
    const std::uint8_t* p = frame.data + 3 * static_cast<std::size_t>(i) * step;
    for (int k = 0; k < 3; ++k) rows.at<double>(i, k) = p[k];
  }
  return rows;
}

/// What predict takes for a sample, scaled to the frame.
double em_predict_ms(const cv::Mat& frame, int components) {
  const auto em = cv::ml::EM::create();
  em->setClustersNumber(components);
  em->setCovarianceMatrixType(cv::ml::EM::COV_MAT_GENERIC);
  em->setTermCriteria({cv::TermCriteria::COUNT, 5, 0.0});
  em->trainEM(pixels_as_rows(frame, kEmTraining_px));
  const cv::Mat sample = pixels_as_rows(frame, kEmSample_px);
  cv::Mat probabilities;
  const double sample_ms = milliseconds([&] { em->predict(sample, probabilities); });
  return sample_ms * static_cast<double>(frame.total()) / kEmSample_px;
}

}  // namespace

SegmentBench bench_segment(std::span<const cv::Mat> bgr_frames) {
  const cv::Mat& first = bgr_frames.front();
  TerrainMixture mixture{MixtureParams{}};
  mixture.start(bytes_of(first), first.cols, first.rows);
  for (std::size_t i = 0; i < 16; ++i) train_once(mixture, bgr_frames[i % bgr_frames.size()], i);

  Segmenter segmenter(first.cols, first.rows);
  std::vector<std::uint8_t> copy(bytes_of(first).size());
  std::vector<double> copy_ms, steady_ms, changed_ms;
  for (int round = 0; round <= kRounds; ++round) {
    for (const cv::Mat& frame : bgr_frames) {
      const double c = milliseconds([&] { std::memcpy(copy.data(), frame.data, copy.size()); });
      const double s = milliseconds([&] { segmenter.segment(bytes_of(frame), mixture); });
      if (round == 0) continue;  // its colours are new
      copy_ms.push_back(c);
      steady_ms.push_back(s);
    }
  }
  for (std::size_t i = 0; i < bgr_frames.size(); ++i) {
    train_once(mixture, bgr_frames[i], i);
    changed_ms.push_back(milliseconds([&] { segmenter.segment(bytes_of(bgr_frames[i]), mixture); }));
  }
  SegmentBench result;
  result.memcpy_ms = median(copy_ms);
  result.segment_steady_ms = median(steady_ms);
  result.segment_changed_ms = median(changed_ms);
  result.em_predict_ms = em_predict_ms(first, static_cast<int>(mixture.components().size()));
  result.em_sample_px = kEmSample_px;
  return result;
}

}  // namespace hindsight::tools
