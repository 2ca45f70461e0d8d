// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/segmenter.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>

#include "perception/multiversion.h"

namespace hindsight {
namespace {

constexpr std::size_t kBlock_px = 64;  ///< one bit each in a word
constexpr std::size_t kGroup_px = 8;
constexpr std::size_t kOverhang = 4;  ///< bytes read behind the last pixel of a block
constexpr unsigned kGenerationShift = 3;
constexpr unsigned kGenerations = 31;
constexpr std::uint8_t kStateBits = 7;
constexpr std::uint8_t kMixed = ColorClassifier::kMixed;
constexpr std::uint32_t kNotYet = ~0u;  ///< no octant's labels

static_assert(std::endian::native == std::endian::little, "the cubes of pixels are taken from words");

/// Reads one byte behind the pixel.
std::uint32_t key_at(const std::uint8_t* pixel) {
  std::uint32_t word;
  std::memcpy(&word, pixel, sizeof word);
  return word & 0xFFFFFFu;
}

/// Small cubes of eight pixels; reads kOverhang bytes behind them.
HINDSIGHT_ALWAYS_INLINE void cubes_of(const std::uint8_t* bgr, std::uint32_t* cubes) {
  using Half = std::uint64_t __attribute__((vector_size(16)));
  using Bytes = std::uint8_t __attribute__((vector_size(32)));
  using Words = std::uint32_t __attribute__((vector_size(32)));
  // Behind each pixel comes a byte that does not count.
  constexpr Bytes spread{0,  1,  2,  0,  3,  4,  5,  0,  6,  7,  8,  0,  9,  10, 11, 0,
                         16, 17, 18, 16, 19, 20, 21, 16, 22, 23, 24, 16, 25, 26, 27, 16};
  Half first, second;
  std::memcpy(&first, bgr, sizeof first);
  std::memcpy(&second, bgr + 12, sizeof second);
  const Bytes bytes = __builtin_shuffle(Bytes(__builtin_shufflevector(first, second, 0, 1, 2, 3)), spread);
  Words key, cube;
  std::memcpy(&key, &bytes, sizeof key);
  find_small_cube(key, cube);
  std::memcpy(cubes, &cube, sizeof cube);
}

/// One bit for each byte that is no label, the first byte's lowest.
HINDSIGHT_ALWAYS_INLINE std::uint64_t no_labels(std::uint64_t eight) {
  constexpr std::uint64_t kLow = 0x7F7F7F7F7F7F7F7Fu, kNoLabel = 0xFCFCFCFCFCFCFCFCu;
  const std::uint64_t no_label = eight & kNoLabel;
  const std::uint64_t top_bits = (((no_label & kLow) + kLow) | no_label) & ~kLow;
  return (top_bits >> 7) * 0x0102040810204080u >> 56;
}

/// Cubes of a block's pixels and their states; returns which states are no labels. Those of another
/// generation have bits beyond kStateBits.
HINDSIGHT_MULTIVERSION
std::uint64_t look_up(const std::uint8_t* table, std::uint8_t generation, const std::uint8_t* bgr,
                      std::uint32_t* cubes, std::uint8_t* states) {
  const std::uint64_t present =
      0x0101010101010101u * static_cast<std::uint8_t>(generation << kGenerationShift);
  std::uint64_t unlabelled = 0;
  for (std::size_t i = 0; i < kBlock_px; i += kGroup_px) {
    cubes_of(bgr + 3 * i, cubes + i);
    std::uint64_t eight = 0;
    for (std::size_t k = 0; k < kGroup_px; ++k)
      eight |= static_cast<std::uint64_t>(table[cubes[i + k]]) << 8 * k;
    eight ^= present;
    unlabelled |= no_labels(eight) << i;
    std::memcpy(states + i, &eight, sizeof eight);
  }
  return unlabelled;
}

}  // namespace

/// In runs short enough to count in bytes, which vectorises.
HINDSIGHT_MULTIVERSION
std::array<int, kLabelCount + 1> count_labels(std::span<const TerrainClass> labels) {
  constexpr std::size_t kRun = 240;
  std::array<int, kLabelCount + 1> counts{};
  for (std::size_t begin = 0; begin < labels.size(); begin += kRun) {
    const std::size_t end = std::min(begin + kRun, labels.size());
    for (std::uint8_t label = 0; label < counts.size(); ++label) {
      std::uint8_t found = 0;
      for (std::size_t i = begin; i < end; ++i)
        found = static_cast<std::uint8_t>(found + (labels[i] == static_cast<TerrainClass>(label)));
      counts[label] += found;
    }
  }
  return counts;
}

TerrainClass classify_reference(const TerrainMixture& mixture, std::uint8_t b, std::uint8_t g,
                                std::uint8_t r) {
  MixtureLikelihood likelihood(kMostComponents);
  likelihood.set(mixture);
  return likelihood.classify(color_of(mixture.color_space(), b, g, r));
}

Segmenter::Segmenter(int width_px, int height_px)
    : pixels_(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px)),
      labels_(pixels_ + kBlock_px, static_cast<std::uint8_t>(TerrainClass::unknown)),
      cubes_(kSmallCubes),
      mixed_(kSmallCubes * sizeof(MixedCube)) {
  known_.reserve(kMostComponents);
}

std::span<const TerrainClass> Segmenter::segment(std::span<const std::uint8_t> bgr,
                                                 const TerrainMixture& mixture) {
  assert(bgr.size() == 3 * pixels_);
  follow(mixture);
  const std::size_t last = (pixels_ - 1) / kBlock_px * kBlock_px;
  for (std::size_t begin = 0; begin < last; begin += kBlock_px) label_block(&bgr[3 * begin], begin);
  // Behind the last block nothing may be read.
  std::array<std::uint8_t, 3 * kBlock_px + kOverhang> copy{};
  std::ranges::copy(bgr.subspan(3 * last), copy.begin());
  label_block(copy.data(), last);
  static_assert(sizeof(TerrainClass) == 1);
  return {reinterpret_cast<const TerrainClass*>(labels_.data()), pixels_};
}

/// Starts a new generation if the mixture classifies otherwise than the one that the tables stand for.
/// Compared by content, as another mixture may have the same version number; 64 components take less than a
/// microsecond.
void Segmenter::follow(const TerrainMixture& mixture) {
  const std::vector<MixtureComponent>& components = mixture.components();
  if (mixture.params().gate == known_gate_ && mixture.color_space() == known_space_ &&
      mixture.params().class_density == known_density_ && components == known_) {
    return;
  }
  known_gate_ = mixture.params().gate;
  known_density_ = mixture.params().class_density;
  known_space_ = mixture.color_space();
  known_.assign(components.begin(), components.end());
  classifier_.set(mixture);
  forget();
}

void Segmenter::forget() {
  if (generation_ == kGenerations) {
    std::ranges::fill(cubes_, std::uint8_t{0});
    generation_ = 0;
  }
  ++generation_;
}

/// `bgr` are the block's pixels.
void Segmenter::label_block(const std::uint8_t* bgr, std::size_t begin) {
  std::array<std::uint32_t, kBlock_px> cubes;
  std::uint8_t* const labels = &labels_[begin];
  std::uint64_t unlabelled = look_up(cubes_.data(), generation_, bgr, cubes.data(), labels);
  for (; unlabelled != 0; unlabelled &= unlabelled - 1) {
    const auto pixel = static_cast<std::size_t>(std::countr_zero(unlabelled));
    if (labels[pixel] > kMixed) {
      labels[pixel] = state_of_cube(cubes[pixel]);
      if (labels[pixel] != kMixed) continue;
    }
    labels[pixel] = label_in_mixed(cubes[pixel], place_in_small_cube(key_at(bgr + 3 * pixel)));
  }
}

/// Judges it, and the others in its large cube, if an earlier pixel of the same block has not done so.
std::uint8_t Segmenter::state_of_cube(std::uint32_t small_cube) {
  if (cubes_[small_cube] >> kGenerationShift != generation_) {
    const std::uint32_t first = small_cube / kFamily * kFamily;
    const ColorClassifier::Family& family = classifier_.judge(small_cube / kFamily);
    for (std::uint32_t i = 0; i < kFamily; ++i) {
      cubes_[first + i] = static_cast<std::uint8_t>(generation_ << kGenerationShift | family.state[i]);
      if (family.state[i] != kMixed) continue;
      mixed(first + i).matters = family.matters[i];
      std::ranges::fill(mixed(first + i).labels, kNotYet);
    }
  }
  return cubes_[small_cube] & kStateBits;
}

/// Classifies the colours of an octant when the first of them comes.
inline std::uint8_t Segmenter::label_in_mixed(std::uint32_t small_cube, std::uint32_t place) {
  std::uint32_t& labels = mixed(small_cube).labels[place / kFamily];
  if (labels == kNotYet) {
    const std::uint64_t matters = mixed(small_cube).matters;
    labels = classifier_.classify(small_cube, place / kFamily, matters);
  }
  return labels >> place % kFamily * 4 & 15;
}

}  // namespace hindsight
