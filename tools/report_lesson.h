// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <opencv2/core.hpp>

#include "daemon/learner.h"

namespace hindsight::tools {

/// What a training event touched and where that was seen first: on the left the frame in which the patch
/// holds, on the right the one that its middle was traced to, both as the appearance history keeps them;
/// below each, the patch magnified. Empty where the patch was not in view or a frame is no longer held.
cv::Mat draw_lesson(const Lesson& lesson, const AppearanceHistory& appearance);

}  // namespace hindsight::tools
