// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

namespace hindsight::tools {

/// Frames a second at 720 x 480 on one core that the simulator's camera takes over the forest course, looked
/// at on the straight way from start to goal, without truth and without JPEG: the median frame's processor
/// time. FatalError(kExitNoDevice) where there is no EGL.
double bench_render_fps();

}  // namespace hindsight::tools
