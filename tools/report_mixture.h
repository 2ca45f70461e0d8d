// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "perception/terrain_mixture.h"
#include "tools/report_style.h"

namespace hindsight::tools {

/// The colour of the screen that a mean stands for, clipped to what a screen can show.
Rgb screen_color(ColorSpace space, const Eigen::Vector3d& mean);

/// HTML: each component's mean colour, spread, votes, class and weight; those with most votes first.
std::string mixture_table(const TerrainMixture& mixture);

/// SVG: each component as an ellipse of one standard deviation in the plane of two channels (a* and b*, or
/// red and green), filled with its colour, outlined in its class's.
std::string mixture_chart(const TerrainMixture& mixture);

}  // namespace hindsight::tools
