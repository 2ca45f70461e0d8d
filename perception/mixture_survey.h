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

/// The same of eight boxes at once. A set of components is a word of 64 bits: of few, bit j stands for the
/// j-th of those asked about; of more, a bit stands for two neighbours, at least one of which belongs.
struct Outlooks {
  static constexpr std::size_t kMostComponents = 126;  ///< no set has all bits

  std::int32_t label[kFamily];     ///< a class as a number, or -1: not decided
  std::uint64_t matters[kFamily];  ///< the components that matter, and perhaps others
};
constexpr std::size_t components_per_bit(std::size_t asked_about) { return asked_about < 64 ? 1 : 2; }

/// Boxes inside one for which survey() has left at most Outlooks::kMostComponents.
void survey_family(const FloatMixture& mixture, const ComponentSelection& selection, const ColorBoxes& boxes,
                   Outlooks& outlooks);

}  // namespace hindsight
