// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

namespace hindsight {

/// Keeps OpenCV from using its own thread pool, which would take cores from the loop and add jitter. Call
/// once, at the start of main.
void keep_opencv_single_threaded();

}  // namespace hindsight
