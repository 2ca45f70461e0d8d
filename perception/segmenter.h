// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "perception/color_classifier.h"
#include "perception/large_table.h"
#include "perception/terrain_class.h"
#include "perception/terrain_mixture.h"

namespace hindsight {

/// Maximum-likelihood class of a colour, evaluated plainly in double precision: the definition that Segmenter
/// equals.
///
/// (5.1) f(c|l) as class_density says (mixture_likelihood.h); the class with the largest wins, the first in
/// the order lethal, bad, good, unlabelled where equal. With class_density = "labels", components without a
/// class (no votes yet) form a fourth group, which competes like a class and wins as `unknown`: without it
/// the first lethal component would own every colour that nobody has voted on yet. (5.2) `unknown` also if
/// the Mahalanobis distance to every component exceeds the gate. So `unknown` means "nothing learned comes
/// near", and it is up to the map to let that cost nothing.
TerrainClass classify_reference(const TerrainMixture& mixture, std::uint8_t b, std::uint8_t g,
                                std::uint8_t r);

/// Pixels by class: good, bad, lethal, unknown.
std::array<int, kLabelCount + 1> count_labels(std::span<const TerrainClass> labels);

/// Labels every pixel of a frame. Not thread safe. About 15 MB, most of it a table of all 2^24 colours: a
/// pixel's label depends on its colour alone. Most cubes of 4 x 4 x 4 colours have one class, so the table of
/// cubes is asked first, and it stays in the processor's near cache; the colours of a mixed cube stand
/// together, beside those of cubes alike. A cube is judged, and an octant of a mixed one
/// classified, when a colour of it first comes after a change of the mixture.
class Segmenter {
 public:
  Segmenter(int width_px, int height_px);

  /// One label a pixel, row-major; valid until the next call. `bgr` is row-major, three bytes a pixel, no
  /// padding, of the size given at construction (an assertion checks it). Equal to classify_reference for
  /// every pixel. A mixture that has not started makes every pixel unknown. Allocates only where the
  /// mixture's colour space is another one than the last.
  std::span<const TerrainClass> segment(std::span<const std::uint8_t> bgr, const TerrainMixture& mixture);

 private:
  void follow(const TerrainMixture& mixture);
  void forget();
  void label_block(const std::uint8_t* bgr, std::size_t begin);
  std::uint8_t state_of_cube(std::uint32_t small_cube);
  std::uint8_t label_in_mixed(std::uint32_t small_cube, std::uint32_t place);

  /// A small cube of several classes.
  struct MixedCube {
    std::uint32_t labels[kFamily];  ///< of an octant, four bits each, by place; or kNotYet
    std::uint64_t matters;          ///< the classifier's
  };
  MixedCube& mixed(std::uint32_t small_cube) {
    return reinterpret_cast<MixedCube*>(mixed_.data())[small_cube];
  }

  std::size_t pixels_;
  std::vector<std::uint8_t> labels_;  ///< TerrainClass as numbers, up to whole blocks
  /// By small cube: generation << 3 | label or ColorClassifier::kMixed. Only those of the present generation
  /// count, so a change of the mixture costs nothing but a new generation.
  std::vector<std::uint8_t> cubes_;
  LargeTable mixed_;                     ///< MixedCube by small cube
  std::uint8_t generation_ = 1;          ///< 1..31
  std::vector<MixtureComponent> known_;  ///< the components that the tables stand for
  ColorSpace known_space_ = ColorSpace::rgb;
  double known_gate_ = 0.0;
  std::string known_density_;
  ColorClassifier classifier_;
};

}  // namespace hindsight
