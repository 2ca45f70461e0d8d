// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// A mixture as bytes, for the file in which it outlives the process. Reading and writing the file is done
// elsewhere.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "perception/terrain_mixture.h"

namespace hindsight {

/// Little-endian: "HSMX", u16 version, u8 colour space, u8 zero, u32 number of components n, then n
/// components (mean 3, covariance 6 (upper triangle by rows), weight, votes 3; all f64; u8 label), then
/// the votes of textures (3 classes x 64, f64), then the CRC-32 (IEEE 802.3) of all bytes before it. Version
/// 1 had no textures.
std::vector<std::uint8_t> encode_mixture(const MixtureSnapshot& mixture);

struct MixtureDecoded {
  MixtureSnapshot mixture;
  std::string
      problem;  ///< empty: whole and sound; else what is wrong and at which byte, and `mixture` is empty
};
/// Refuses everything that encode_mixture cannot have written: wrong length, magic, version or checksum, more
/// than 256 components, numbers that are not finite, covariances that are not positive definite, negative
/// votes or weights.
MixtureDecoded decode_mixture(std::span<const std::uint8_t> bytes);

}  // namespace hindsight
