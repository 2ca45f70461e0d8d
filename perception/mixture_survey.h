// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "perception/color_cubes.h"
#include "perception/float_mixture.h"

namespace hindsight {

/// What can be said of all colours of a box together.
struct Outlook {
  bool decided;        ///< all have the same class
  std::int32_t label;  ///< that class as a number
};

/// Bounds each component's distance and likelihood over the box. Where that does not decide the class,
/// `selection` gets the components that matter inside it: a colour's class follows from them alone.
Outlook survey(const FloatMixture& mixture, const ColorBox& box, ComponentSelection& selection);

}  // namespace hindsight
