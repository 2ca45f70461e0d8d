// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/single_thread.h"

#include <opencv2/core/utility.hpp>

namespace hindsight {

void keep_opencv_single_threaded() { cv::setNumThreads(1); }

}  // namespace hindsight
