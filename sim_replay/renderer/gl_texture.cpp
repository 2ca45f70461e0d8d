// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/gl_texture.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "sim_replay/world/random.h"

namespace hindsight {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Rounded up or down at random: flat places keep their mean.
std::uint8_t dithered(float value, Random& random) {
  const double scaled = std::clamp(static_cast<double>(value), 0.0, 1.0) * 255.0 + random.uniform(0.0, 1.0);
  return static_cast<std::uint8_t>(std::min(scaled, 255.0));
}

Bytes bytes_of(const Texels& picture, float full, float alpha_gain) {
  Random random(1);
  Bytes bytes;
  bytes.reserve(picture.rgba.size() * 4);
  for (const glm::vec4& texel : picture.rgba) {
    for (int i = 0; i < 3; ++i) bytes.push_back(dithered(texel[i] / full, random));
    bytes.push_back(static_cast<std::uint8_t>(std::clamp(texel.a * alpha_gain, 0.0F, 1.0F) * 255.0F + 0.5F));
  }
  return bytes;
}

Texels halved(const Texels& from) {
  Texels to(std::max(1, from.width / 2), std::max(1, from.height / 2));
  const int step_x = from.width > 1 ? 1 : 0, step_y = from.height > 1 ? 1 : 0;
  for (int y = 0; y < to.height; ++y) {
    for (int x = 0; x < to.width; ++x) {
      const int u = 2 * x * step_x, v = 2 * y * step_y;
      to.at(x, y) = 0.25F * (from.at(u, v) + from.at(u + step_x, v) + from.at(u, v + step_y) +
                             from.at(u + step_x, v + step_y));
    }
  }
  return to;
}

float coverage(const Texels& picture, float alpha_gain) {
  const auto above = std::count_if(picture.rgba.begin(), picture.rgba.end(),
                                   [&](const glm::vec4& texel) { return texel.a * alpha_gain > 0.5F; });
  return static_cast<float>(above) / static_cast<float>(picture.rgba.size());
}

float gain_for(const Texels& picture, float wanted) {
  float low = 0.1F, high = 10.0F;
  for (int i = 0; i < 12; ++i) {
    const float middle = 0.5F * (low + high);
    (coverage(picture, middle) < wanted ? low : high) = middle;
  }
  return high;
}

void upload(GLuint id, int layer, Texels picture, Coverage kept) {
  const float wanted = coverage(picture, 1.0F);
  for (int level = 0;; ++level) {
    const float gain = kept == Coverage::kept && level > 0 ? gain_for(picture, wanted) : 1.0F;
    const Bytes bytes = bytes_of(picture, kFullAlbedo, gain);
    glTextureSubImage3D(id, level, 0, 0, layer, picture.width, picture.height, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                        bytes.data());
    if (picture.width == 1 && picture.height == 1) return;
    picture = halved(picture);
  }
}

}  // namespace

GlTextureArray::GlTextureArray(const std::vector<Texels>& layers, Coverage kept) {
  const int width = layers.front().width, height = layers.front().height;
  glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &id_);
  glTextureStorage3D(id_,
                     static_cast<GLsizei>(std::bit_width(static_cast<unsigned>(std::max(width, height)))),
                     GL_RGBA8, width, height, static_cast<GLsizei>(layers.size()));
  for (std::size_t i = 0; i < layers.size(); ++i) upload(id_, static_cast<int>(i), layers[i], kept);
  glTextureParameteri(id_, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTextureParameteri(id_, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

GlQuickSampler::GlQuickSampler() {
  glCreateSamplers(1, &id_);
  glSamplerParameteri(id_, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  glSamplerParameteri(id_, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

GlMasks::GlMasks(const std::vector<const Texels*>& layers) {
  const int width = layers.front()->width, height = layers.front()->height;
  glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &id_);
  glTextureStorage3D(id_, 1, GL_RGBA8, width, height, static_cast<GLsizei>(layers.size()));
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const Bytes bytes = bytes_of(*layers[i], 1.0F, 1.0F);
    glTextureSubImage3D(id_, 0, 0, 0, static_cast<GLint>(i), width, height, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                        bytes.data());
  }
  for (const GLenum filter : std::initializer_list<GLenum>{GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
    glTextureParameteri(id_, filter, GL_LINEAR);
  }
  for (const GLenum wrap : std::initializer_list<GLenum>{GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
    glTextureParameteri(id_, wrap, GL_CLAMP_TO_EDGE);
  }
}

}  // namespace hindsight
