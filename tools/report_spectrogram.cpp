// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/report_spectrogram.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "tools/report_style.h"

namespace hindsight::tools {

cv::Mat draw_spectrogram(const SpectrumTrace& trace, int most_columns) {
  if (trace.bins < 2) return {};
  const auto ticks = trace.amplitudes.size() / trace.bins;
  const auto columns = std::min(ticks, static_cast<std::size_t>(most_columns));
  if (columns == 0) return {};
  cv::Mat level(static_cast<int>(trace.bins) - 1, static_cast<int>(columns), CV_8UC1, cv::Scalar(0));
  cv::Mat known(level.size(), CV_8UC1, cv::Scalar(0));
  for (std::size_t tick = 0; tick < ticks; ++tick) {
    const int column = static_cast<int>(tick * columns / ticks);
    for (std::size_t bin = 1; bin < trace.bins; ++bin) {
      const float amplitude = trace.amplitudes[tick * trace.bins + bin];
      if (std::isnan(amplitude)) continue;
      const int row = static_cast<int>(trace.bins - 1 - bin);
      auto& present = level.at<std::uint8_t>(row, column);
      present = std::max(present, cv::saturate_cast<std::uint8_t>(255.0F * amplitude / kBrightestAmplitude));
      known.at<std::uint8_t>(row, column) = 1;
    }
  }
  cv::Mat picture;
  cv::applyColorMap(level, picture, cv::COLORMAP_VIRIDIS);
  picture.setTo(kFaint.bgr(), known == 0);
  return picture;
}

}  // namespace hindsight::tools
