// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Many like colours at once: single precision where its error cannot matter, double precision where it could.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "perception/color_cubes.h"
#include "perception/float_mixture.h"
#include "perception/mixture_survey.h"
#include "perception/terrain_mixture.h"

namespace hindsight {

/// Classes of cubes of colours by (5.1) and (5.2), always equal to MixtureLikelihood's. It bounds the
/// distance to each component over a large cube, then over a small one, which leaves a few components, mostly
/// of one class. Where that does not decide, it evaluates those for each colour in vectors of floats, and
/// asks MixtureLikelihood wherever the two largest likelihoods, or distance and gate, are closer than the
/// floats' error bound. Allocates at construction, and in set() where that brings another colour space. Not
/// thread safe.
class ColorClassifier {
 public:
  /// Not a label: the cube's colours are not all of one class.
  static constexpr std::uint8_t kMixed = 4;

  ColorClassifier();

  void set(const TerrainMixture& mixture);

  /// The class of all 64 colours of a small cube, or kMixed and the class of each, by place_in_small_cube.
  std::uint8_t classify(std::uint32_t small_cube, std::uint8_t* labels);

 private:
  /// What is known of a large cube: a label, or the components that matter, as in ComponentSelection.
  enum class Known : std::uint8_t { good, bad, lethal, unknown, selection, too_many, nothing };
  struct Remembered {
    static constexpr std::size_t kMost = 59;
    std::uint8_t group_end[FloatMixture::kGroups];
    std::uint8_t count;
    std::uint8_t column[kMost];
  };

  Known look_at_large(std::uint32_t large_cube);
  void take_part_for(std::uint32_t large_cube);
  void classify_each(std::uint32_t small_cube, std::uint8_t* labels);

  MixtureLikelihood exact_;
  ColorSpace color_space_ = ColorSpace::rgb;
  ColorCubes cubes_;
  FloatMixture mixture_{};
  std::vector<Known> known_;             ///< by large cube
  std::vector<Remembered> remembered_;   ///< by large cube; of those that are Known::selection
  FloatMixture part_{};                  ///< of mixture_, what matters to the large cube part_of_
  std::uint32_t part_of_ = kLargeCubes;  ///< kLargeCubes: none
  ComponentSelection selection_{};
};

}  // namespace hindsight
