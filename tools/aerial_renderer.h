// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Pictures of an aerial world from a swaying platform, with exact truth.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "tools/aerial_camera.h"
#include "tools/aerial_world.h"
#include "tools/eval_tracks_truth.h"

namespace hindsight::tools {

/// A picture and what moves in it. An object counts where it is seen: a third of it or more not hidden, and
/// its middle in the picture. Its shadow moves too, but is not the object: a box of its own that does not
/// count, so that a track over it is neither right nor over a part of the scene that stands still.
struct AerialFrame {
  cv::Mat bgr;
  std::vector<TrueBox> truth;
};

/// Flat textured quadrilaterals, painted from the farthest to the nearest, over a large ground picture;
/// shadows and the sensor's noise. Simple, but with what matters here: parallax, hiding, texture, flat grass,
/// and objects that look like parked ones.
class AerialRenderer {
 public:
  explicit AerialRenderer(const AerialWorld& world);

  /// `noise_seed`: of the sensor's noise.
  AerialFrame render(const AerialCamera& camera, const AerialTraffic& traffic, double t_s,
                     std::uint64_t noise_seed);

 private:
  struct Quad {
    std::array<cv::Vec3d, 4> corners_m;
    const cv::Mat* texture = nullptr;  ///< BGRA
    int id = 0;                        ///< of the mover; 0: of the world
  };

  void draw_ground_texture(const AerialWorld& world);
  void make_sprites(std::uint64_t seed);
  void add_box(std::vector<Quad>& quads, cv::Point2d centre, cv::Size2d size, double turn, double z0,
               double z1, const cv::Mat& top, const cv::Mat& side, int id) const;
  void add_mover(std::vector<Quad>& quads, std::vector<Quad>& shadows, const MoverState& mover,
                 double t_s) const;
  void paint(const Quad& quad, const cv::Matx34d& projection, cv::Mat& picture, cv::Mat* ids) const;

  std::vector<Quad> statics_;
  cv::Mat ground_, shadow_, wall_;
  std::vector<cv::Mat> roofs_, crowns_, cars_, car_sides_, people_, cycles_;
  cv::Mat noise_;
};

}  // namespace hindsight::tools
