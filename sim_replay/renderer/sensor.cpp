// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/sensor.h"

#include "sim_replay/renderer/scene_view.h"
#include "sim_replay/renderer/shaders.h"

namespace hindsight {
namespace {

/// Light 1 fills a pixel in 1/700 s.
constexpr float kSensitivity_per_s = 700.0F;
constexpr float kFullWell_electrons = 9000.0F;
constexpr float kRead_electrons = 12.0F;
constexpr float kVignette = 0.16F;
/// First exposures go unseen, until the meter has found its level.
constexpr int kSettlingPictures = 6;

/// From a wide pixel with 1 / depth now to where that point was before, homogeneous.
glm::mat4 before_from_now(const Sensor::Motion& motion, const WidePinhole& wide) {
  glm::dmat4 K(1.0);
  K[0][0] = wide.fx_px, K[1][1] = wide.fy_px;
  K[2][0] = wide.cx_px, K[2][1] = wide.cy_px;
  const glm::dmat3 R = glm::transpose(motion.before.R_WC) * motion.now.R_WC;
  glm::dmat4 X(R);
  X[3] = glm::dvec4(glm::transpose(motion.before.R_WC) * (motion.now.p_WC - motion.before.p_WC), 1.0);
  return glm::mat4(K * X * glm::inverse(K));
}

void drop_alpha_and_swap(const std::vector<std::uint8_t>& bgra, std::vector<std::uint8_t>& bgr) {
  for (std::size_t i = 0, n = bgr.size() / 3; i < n; ++i) {
    for (std::size_t c = 0; c < 3; ++c) bgr[3 * i + c] = bgra[4 * i + c];
  }
}

}  // namespace

Sensor::Sensor(const RenderCamera& camera, const Lens& lens, std::uint64_t seed)
    : width_px_(camera.width_px),
      height_px_(camera.height_px),
      wide_(lens.wide),
      program_(shaders::screen_vertex, shaders::sensor_fragment),
      sources_(GL_RG32F, width_px_, height_px_, GL_NEAREST),
      picture_(GL_RGBA8, width_px_, height_px_, GL_NEAREST),
      target_({&picture_}, nullptr),
      rgba_(4 * lens.sources_px.size()),
      frame_(static_cast<std::uint32_t>(seed * 0x9E3779B97F4A7C15U >> 32U)) {
  glTextureSubImage2D(sources_.id(), 0, 0, 0, width_px_, height_px_, GL_RG, GL_FLOAT, lens.sources_px.data());
  program_.set("wide_size", glm::vec2(wide_.width_px, wide_.height_px));
  program_.set("near_m", kNear_m);
  program_.set("vignette", kVignette);
  program_.set("middle", glm::vec2(camera.cx_px, camera.cy_px));
}

void Sensor::take(const GlImage& light, const GlImage& depth, const Motion& motion,
                  std::vector<std::uint8_t>& bgr) {
  for (int i = 0; !settled_ && i < kSettlingPictures; ++i) {
    expose(light, depth, motion, bgr);
    meter_.settle(mean_green(bgr));
  }
  settled_ = true;
  ++frame_;
  exposure_s_ = meter_.exposure_s();
  gain_ = meter_.gain();
  expose(light, depth, motion, bgr);
  meter_.meter(mean_green(bgr), motion.interval_s);
}

void Sensor::expose(const GlImage& light, const GlImage& depth, const Motion& motion,
                    std::vector<std::uint8_t>& bgr) {
  const float gain = meter_.gain();
  program_.set("before_from_now", before_from_now(motion, wide_));
  program_.set("open_share", meter_.exposure_s() / static_cast<float>(motion.interval_s));
  program_.set("exposure", kSensitivity_per_s * meter_.exposure_s() * gain);
  program_.set("electrons", kFullWell_electrons / gain);
  program_.set("read_electrons", kRead_electrons);
  program_.set("frame", frame_);
  light.bind(5);
  depth.bind(6);
  sources_.bind(7);
  glBindFramebuffer(GL_FRAMEBUFFER, target_.id());
  glViewport(0, 0, width_px_, height_px_);
  program_.use();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glReadPixels(0, 0, width_px_, height_px_, GL_BGRA, GL_UNSIGNED_BYTE, rgba_.data());
  drop_alpha_and_swap(rgba_, bgr);
}

}  // namespace hindsight
