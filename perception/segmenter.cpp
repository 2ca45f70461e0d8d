// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/segmenter.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>

namespace hindsight {
namespace {

constexpr std::size_t kColors = std::size_t{1} << 24;
constexpr std::uint32_t kColorMask = 0xFFFFFF;
constexpr std::size_t kBlock_px = 96;
/// Colours are classified by cubes of 8 x 8 x 8.
constexpr std::size_t kCubes = std::size_t{1} << 15;
constexpr std::size_t kCubeColors = 512;
constexpr unsigned kGenerationShift = 3;
constexpr unsigned kGenerations = 31;
constexpr std::uint8_t kPending = 4;
constexpr std::uint32_t kNotLabelBits = 0xFCFCFCFC;

static_assert(std::endian::native == std::endian::little, "look_up reads colours as words");

std::uint32_t load_word(const std::uint8_t* p) {
  std::uint32_t word;
  std::memcpy(&word, p, sizeof word);
  return word;
}

std::uint32_t key_at(const std::uint8_t* p) {
  return static_cast<std::uint32_t>(p[0]) | static_cast<std::uint32_t>(p[1]) << 8 |
         static_cast<std::uint32_t>(p[2]) << 16;
}

std::uint32_t cube_of(std::uint32_t key) {
  return (key >> 3 & 31u) | (key >> 6 & 0x3E0u) | (key >> 9 & 0x7C00u);
}

bool same_density(const MixtureComponent& a, const MixtureComponent& b) {
  return a.label == b.label && a.mean == b.mean && a.covariance == b.covariance;
}

}  // namespace

TerrainClass classify_reference(const TerrainMixture& mixture, std::uint8_t b, std::uint8_t g,
                                std::uint8_t r) {
  MixtureLikelihood likelihood(mixture.components().size());
  likelihood.set(mixture.components(), mixture.params().gate);
  return likelihood.classify(color_of(mixture.color_space(), b, g, r));
}

Segmenter::Segmenter(int width_px, int height_px)
    : pixels_(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px)),
      labels_(pixels_, TerrainClass::unknown),
      table_(kColors),
      classifier_(pixels_),
      missing_(pixels_ + 1),
      by_cube_(pixels_),
      cube_ends_(kCubes + 1) {
  known_.reserve(kMostComponents);
  late_blocks_.reserve(pixels_ / kBlock_px + 1);
}

std::span<const TerrainClass> Segmenter::segment(std::span<const std::uint8_t> bgr,
                                                 const TerrainMixture& mixture) {
  assert(bgr.size() == 3 * pixels_);
  late_blocks_.clear();
  missing_count_ = 0;
  const bool fresh = follow(mixture);
  for (std::size_t begin = 0; begin < pixels_; begin += kBlock_px) {
    const std::size_t end = std::min(begin + kBlock_px, pixels_);
    if (!fresh && look_up(bgr.data(), begin, end)) continue;
    note_missing(bgr.data(), begin, end);
    late_blocks_.push_back(static_cast<std::uint32_t>(begin));
  }
  classify_missing();
  for (const std::uint32_t begin : late_blocks_)
    look_up(bgr.data(), begin, std::min(begin + kBlock_px, pixels_));
  return labels_;
}

/// Starts a new generation if the mixture classifies otherwise than the one that the table stands for.
/// Compared by content, as another mixture may have the same version number; 64 components take less than a
/// microsecond.
bool Segmenter::follow(const TerrainMixture& mixture) {
  const std::vector<MixtureComponent>& components = mixture.components();
  if (mixture.params().gate == known_gate_ && mixture.color_space() == known_space_ &&
      std::ranges::equal(components, known_, same_density)) {
    return false;
  }
  known_gate_ = mixture.params().gate;
  known_space_ = mixture.color_space();
  known_.assign(components.begin(), components.end());
  classifier_.set(mixture);
  forget();
  return true;
}

/// One slice of the table is cleared at each new generation, all of them within kGenerations: when a number
/// comes round again, no entry bears it any more.
void Segmenter::forget() {
  generation_ = static_cast<Entry>(generation_ % kGenerations + 1);
  constexpr std::size_t slice = kColors / kGenerations + 1;
  const std::size_t begin = next_slice_ * slice, end = std::min(begin + slice, kColors);
  std::memset(table_.data() + begin, 0, end - begin);
  next_slice_ = (next_slice_ + 1) % kGenerations;
}

/// Labels of a block of pixels from the table; false if an entry is missing, and then what it wrote is void.
/// Four pixels at a time, twelve bytes: the label's bits are what is left of an entry without its generation.
bool Segmenter::look_up(const std::uint8_t* bgr, std::size_t begin, std::size_t end) {
  const std::uint8_t* const table = table_.data();
  const std::uint32_t generation = generation_ * (0x01010101u << kGenerationShift);
  std::uint32_t seen = 0;
  std::size_t i = begin;
  for (; i + 4 <= end; i += 4) {
    const std::uint8_t* p = bgr + 3 * i;
    const std::uint32_t four = (static_cast<std::uint32_t>(table[load_word(p) & kColorMask]) |
                                static_cast<std::uint32_t>(table[load_word(p + 3) & kColorMask]) << 8 |
                                static_cast<std::uint32_t>(table[load_word(p + 6) & kColorMask]) << 16 |
                                static_cast<std::uint32_t>(table[load_word(p + 8) >> 8]) << 24) ^
                               generation;
    seen |= four;
    std::memcpy(&labels_[i], &four, sizeof four);
  }
  for (; i < end; ++i) {
    const std::uint32_t one = table[key_at(bgr + 3 * i)] ^ (generation & 0xFFu);
    seen |= one;
    labels_[i] = static_cast<TerrainClass>(one);
  }
  return (seen & kNotLabelBits) == 0;
}

/// The entries are asked for ahead, as the branches on them cannot be foretold and would wait for each in
/// turn.
void Segmenter::note_missing(const std::uint8_t* bgr, std::size_t begin, std::size_t end) {
  Entry* const table = table_.data();
  for (std::size_t i = begin; i < end; ++i) __builtin_prefetch(&table[key_at(bgr + 3 * i)], 1);
  std::size_t count = missing_count_;
  const auto pending = static_cast<Entry>(generation_ << kGenerationShift | kPending);
  for (std::size_t i = begin; i < end; ++i) {
    const std::uint32_t key = key_at(bgr + 3 * i);
    if (table[key] >> kGenerationShift == generation_) continue;
    table[key] = pending;
    missing_[count++] = key;
  }
  missing_count_ = count;
}

/// Counting sort by cube, then one call for each cube.
void Segmenter::classify_missing() {
  if (missing_count_ == 0) return;
  const std::span<const std::uint32_t> missing(missing_.data(), missing_count_);
  std::ranges::fill(cube_ends_, 0u);
  for (const std::uint32_t key : missing) ++cube_ends_[cube_of(key) + 1];
  for (std::size_t cube = 1; cube <= kCubes; ++cube) cube_ends_[cube] += cube_ends_[cube - 1];
  for (const std::uint32_t key : missing) by_cube_[cube_ends_[cube_of(key)]++] = key;

  classifier_.load({by_cube_.data(), missing_count_});
  const auto present = static_cast<Entry>(generation_ << kGenerationShift);
  Entry* const table = table_.data();
  std::array<std::uint8_t, kCubeColors> labels;
  for (std::size_t cube = 0, begin = 0; cube < kCubes; begin = cube_ends_[cube++]) {
    const std::size_t end = cube_ends_[cube];
    if (begin == end) continue;
    classifier_.classify(begin, end, labels.data());
    for (std::size_t i = begin; i < end; ++i) table[by_cube_[i]] = present | labels[i - begin];
  }
}

std::array<int, kLabelCount + 1> Segmenter::class_counts() const {
  std::array<int, kLabelCount + 1> counts{};
  for (std::size_t label = 0; label < counts.size(); ++label) {
    counts[label] = static_cast<int>(std::ranges::count(labels_, static_cast<TerrainClass>(label)));
  }
  return counts;
}

}  // namespace hindsight
