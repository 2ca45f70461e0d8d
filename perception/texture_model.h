// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Which textures obstacles have, and which the ground: a histogram of texture codes for each class.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "perception/terrain_class.h"
#include "perception/texture_code.h"

namespace hindsight {

/// Training events by class and texture code; one event is one vote, shared by its pixels.
using TextureVotes = std::array<std::array<double, kTextureCodes>, kLabelCount>;

/// Natural logarithm of how much likelier each texture is on an obstacle than on good ground.
using TextureLogRatios = std::array<float, kTextureCodes>;

/// One thread. No allocation.
class TextureModel {
 public:
  /// One training event: the codes of the pixels that it trains on. None, or label unknown: nothing happens.
  void train(std::span<const std::uint8_t> codes, TerrainClass label);

  /// Bad and lethal together against good, each as shares of their votes and one more, so that ground seen
  /// often does not outvote few touches, and the first touch is not believed like the tenth. All zero until
  /// there are votes for both. `limit`: no ratio is beyond it.
  TextureLogRatios log_ratios(double limit) const;

  const TextureVotes& votes() const { return votes_; }
  void restore(const TextureVotes& votes) { votes_ = votes; }

 private:
  TextureVotes votes_{};
};

}  // namespace hindsight
