// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <opencv2/core.hpp>

#include "tools/report_trace.h"

namespace hindsight::tools {

/// Amplitude over DC from which a spectrogram is at its brightest.
constexpr float kBrightestAmplitude = 0.5F;

/// Time to the right, frequency up: the bottom row is bin 1 (0 Hz is always 1), the top row the last bin. At
/// most most_columns wide; where several ticks share a column, the largest amplitude shows. Grey while the
/// window fills.
cv::Mat draw_spectrogram(const SpectrumTrace& trace, int most_columns);

}  // namespace hindsight::tools
