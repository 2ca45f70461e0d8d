// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// A grove on flat ground, and what a pinhole camera sees of it. Small on purpose: ray casting on one core.
// Things look different from afar by physics alone: haze, and texture that is finer than a pixel averages
// out.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hindsight {

/// Pinhole without distortion, mounted on a body that is forward-left-up with its origin on the ground.
struct DemoCamera {
  int width_px = 720;
  int height_px = 480;
  double fx_px = 420.0;
  double fy_px = 420.0;
  double cx_px = 359.5;
  double cy_px = 239.5;
  std::array<double, 9> R_BC{};  ///< row-major; C is x right, y down, z forward
  std::array<double, 3> p_BC_m{};
};

/// Planar pose of the body in W (east-north), heading counter-clockwise from east.
struct DemoPose {
  double x_m = 0.0;
  double y_m = 0.0;
  double heading_rad = 0.0;
};

/// An upright trunk under a round crown.
struct DemoTree {
  double x_m = 0.0;  ///< in W
  double y_m = 0.0;
  double radius_m = 0.2;
  double trunk_m = 3.0;  ///< height of the crown's middle
  double crown_m = 1.2;  ///< radius of the crown
};

/// A round patch of mud, on which wheels slip.
struct DemoMud {
  double x_m = 0.0;  ///< in W
  double y_m = 0.0;
  double radius_m = 0.0;
};

struct DemoWorld {
  std::vector<DemoTree> trees;
  DemoMud mud;
};

/// About 25 trees between the origin and `goal_x_m` east of it, some right in the way. The same seed, the
/// same grove.
DemoWorld make_demo_world(double goal_x_m, std::uint64_t seed);

/// Value noise on a torus: smooth, deterministic, its table made once.
class ValueNoise {
 public:
  explicit ValueNoise(std::uint64_t seed);
  /// In [-1, 1]; changes over a length of about 1.
  float at(float x, float y) const;

 private:
  static constexpr int kSide = 256;
  std::vector<float> table_;
};

/// Not thread-safe. Allocates at construction only.
class DemoScene {
 public:
  DemoScene(const DemoWorld& world, const DemoCamera& camera, std::uint64_t seed);

  /// The next picture, from the given pose: BGR, rows without padding; valid until the next call.
  std::span<const std::uint8_t> render(const DemoPose& X_WB);

 private:
  struct Color {
    float b = 0.0F, g = 0.0F, r = 0.0F;
  };
  /// What a pixel's ray is in the body's frame, which never changes.
  struct Ray {
    float x = 0.0F, y = 0.0F, z = 0.0F;  ///< length 1 along the optical axis
    float ground_depth = 0.0F;  ///< where it meets the ground, in its own lengths; 0 where it does not
  };
  /// A disc in the body's frame, seen from the camera: what a trunk or crown is when looked at from above.
  struct Upright {
    float x_m, y_m, radius_m;  ///< relative to the camera
    float middle_m, crown_m;   ///< height of the crown's middle above the camera, its radius
    float bark;                ///< sets one tree's texture apart from another's
  };
  struct Box {
    int left, top, right, bottom;  ///< right and bottom are not in it
  };

  void cast_rays();
  void draw_ground(const DemoPose& X_WB);
  void draw_tree(const Upright& tree);
  void draw_trunk(const Upright& tree, const Box& box);
  void draw_crown(const Upright& tree, const Box& box);
  Box box_around(const Upright& tree, float half_width_m, float low_m, float high_m) const;
  Color sky(const Ray& ray) const;
  Color ground(float x_m, float y_m, float distance_m) const;
  Color bark(const Upright& tree, float nx, float ny, float z_m, float distance_m) const;
  Color leaves(const Upright& tree, float nx, float ny, float nz, float distance_m) const;
  Color in_haze(Color color, float distance_m) const;
  void add_sensor_noise();

  DemoWorld world_;
  DemoCamera camera_;
  ValueNoise noise_;
  std::vector<Ray> rays_;
  std::vector<float> depth_;
  std::vector<Color> colors_;
  std::vector<float> sensor_noise_;
  std::vector<std::uint8_t> bgr_;
  std::uint64_t noise_state_;
};

}  // namespace hindsight
