// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The charts of a report that need nothing but its trace, as SVG.
#pragma once

#include <string>

#include "tools/report_trace.h"

namespace hindsight::tools {

/// Sources, behaviour and stop reason over time, training events as ticks.
std::string state_chart(const RunTrace& trace);

/// Commanded against measured speed of one wheel.
std::string speed_chart(const RunTrace& trace, Wheel wheel);

/// Speed of one wheel against that of the vehicle over the ground under it, as the camera sees it; gaps where it does
/// not.
std::string ground_chart(const RunTrace& trace, Wheel wheel);

/// Confidence in the road over time, a gap where none was seen.
std::string road_chart(const RunTrace& trace);

/// How long steps took, or how late ticks began, with median, 99 % and maximum. `period_ms`: of the loop.
std::string step_histogram(const RunTrace& trace, double period_ms);
/// Empty where no tick was late at all: a replay that was not paced.
std::string latency_histogram(const RunTrace& trace);
/// Both over decades, so that the rare long ones show.
std::string timing_decades(const RunTrace& trace);

/// The axes around a spectrogram's picture file, with the band of slip and the times of slip.
std::string spectrogram_chart(const RunTrace& trace, Wheel wheel, const std::string& file,
                              const SlipDetectorParams& params);

}  // namespace hindsight::tools
