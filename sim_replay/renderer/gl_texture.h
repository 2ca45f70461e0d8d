// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <epoxy/gl.h>

#include <vector>

#include "sim_replay/renderer/texels.h"

namespace hindsight {

/// Colours are held in 8 bits linear; this much light is full scale, since nothing outdoors reflects more.
constexpr float kFullAlbedo = 0.5F;

enum class Coverage { plain, kept };

/// A way to read a texture other than its own: nearest of the smaller versions, for what is small itself.
class GlQuickSampler {
 public:
  GlQuickSampler();
  ~GlQuickSampler() { glDeleteSamplers(1, &id_); }
  GlQuickSampler(const GlQuickSampler&) = delete;
  GlQuickSampler& operator=(const GlQuickSampler&) = delete;
  void bind(GLuint unit) const { glBindSampler(unit, id_); }
  static void unbind(GLuint unit) { glBindSampler(unit, 0); }

 private:
  GLuint id_ = 0;
};

/// A stack of pictures of one size, tiled, with all smaller versions. Coverage::kept: the share of texels
/// whose fourth channel is above one half stays the same in the smaller versions (Castano 2010), so that
/// leaves do not thin out with distance.
class GlTextureArray {
 public:
  GlTextureArray(const std::vector<Texels>& layers, Coverage coverage);
  ~GlTextureArray() { glDeleteTextures(1, &id_); }
  GlTextureArray(const GlTextureArray&) = delete;
  GlTextureArray& operator=(const GlTextureArray&) = delete;
  void bind(GLuint unit) const { glBindTextureUnit(unit, id_); }

 private:
  GLuint id_ = 0;
};

/// A stack of pictures of one size, not tiled, bilinear; texel values 0 to 1.
class GlMasks {
 public:
  explicit GlMasks(const std::vector<const Texels*>& layers);
  ~GlMasks() { glDeleteTextures(1, &id_); }
  GlMasks(const GlMasks&) = delete;
  GlMasks& operator=(const GlMasks&) = delete;
  void bind(GLuint unit) const { glBindTextureUnit(unit, id_); }

 private:
  GLuint id_ = 0;
};

}  // namespace hindsight
