// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string_view>

namespace hindsight {

/// The space in which the terrain mixture lives.
enum class ColorSpace : std::uint8_t {
  rgb = 0,  ///< (R, G, B), each 0..255: the thesis (5.1)
  lab = 1,  ///< CIE 1976 (L*, a*, b*) of sRGB under D65: L* 0..100, a* and b* within about -110..100
};

/// "rgb" or "lab"; anything else throws std::invalid_argument (parameters are checked before they come here).
ColorSpace parse_color_space(std::string_view name);

/// A 24-bit colour in the given space. A function of the three bytes alone and the same on every machine: it
/// uses only additions, multiplications, divisions and the tables made of them, never the C library's pow or
/// cbrt.
Eigen::Vector3d color_of(ColorSpace space, std::uint8_t b, std::uint8_t g, std::uint8_t r);

/// Many colours at once in single precision, for the segmenter: `keys[i]` is b | g << 8 | r << 16, and
/// channel k of colour i goes to out[k][i]; each out[k] must have room for `count` rounded up to a multiple
/// of eight. Each value is within color_float_error(space) of color_of's.
void colors_of(ColorSpace space, const std::uint32_t* keys, int count, float* const out[3]);

/// Bound of |colors_of - color_of| in each channel, over all 2^24 colours (a test walks them all).
double color_float_error(ColorSpace space);

}  // namespace hindsight
