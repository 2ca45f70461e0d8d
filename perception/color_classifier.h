// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Many like colours at once: single precision where its error cannot matter, double precision where it could.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "perception/color_cubes.h"
#include "perception/float_mixture.h"
#include "perception/mixture_survey.h"
#include "perception/terrain_mixture.h"

namespace hindsight {

/// Classes of cubes of colours by (5.1) and (5.2), always equal to MixtureLikelihood's. It bounds the
/// distance to each component over a huge cube, then, to those that matter there, over the large cubes in it,
/// all eight at once, then over the small ones in those: mostly components of one class are left. Where that
/// does not decide, it evaluates those for each colour in vectors of floats, and asks MixtureLikelihood
/// wherever the two largest likelihoods, or distance and gate, are closer than the floats' error bound.
/// Allocates at construction, and in set() where that brings another colour space. Not thread safe.
class ColorClassifier {
 public:
  /// Not a label: the cube's colours may be of several classes.
  static constexpr std::uint8_t kMixed = 4;

  /// What is known of the eight cubes in one of the next size.
  struct Family {
    std::array<std::uint8_t, kFamily> state;  ///< a label, or kMixed
    std::array<std::uint64_t, kFamily>
        matters;  ///< of a mixed one: the components, in a way known to the classifier
  };

  ColorClassifier();

  void set(const TerrainMixture& mixture);

  /// Of the small cubes in a large one; valid until the next call.
  const Family& judge(std::uint32_t large_cube);

  /// The labels of an octant's colours, four bits each by their place in it. The small cube must have been
  /// found mixed by judge() since set(), and `matters` is what that told.
  std::uint32_t classify(std::uint32_t small_cube, std::uint32_t octant, std::uint64_t matters);

 private:
  /// A ComponentSelection that is not too long to be kept.
  struct alignas(64) Remembered {
    static constexpr std::size_t kMost = Outlooks::kMostComponents;
    std::uint8_t column[kMost];
    std::uint8_t count;
  };
  struct Huge {
    bool known;
    Family large_ones;
    Remembered selection;
  };

  const Huge& look_at_huge(std::uint32_t huge_cube);
  void survey_inside(const ColorBoxes& boxes, Remembered& memory, Family& family);

  MixtureLikelihood exact_;
  ColorSpace color_space_ = ColorSpace::rgb;
  ColorCubes cubes_;
  FloatMixture mixture_{};
  std::vector<Huge> huge_;              ///< by huge cube
  std::vector<Remembered> remembered_;  ///< by large cube, of those with mixed ones inside
  Family family_{};
  ComponentSelection selection_{};
};

}  // namespace hindsight
