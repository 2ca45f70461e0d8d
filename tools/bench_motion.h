// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

namespace hindsight::tools {

/// Frames a second at 640 x 480 on one core that tracking takes beside the flow, over a simulated crossing:
/// the median frame's processor time.
double bench_motion_fps();

}  // namespace hindsight::tools
