// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/demo_scene.h"

#include <algorithm>
#include <cmath>

#include "sim_replay/demo_random.h"

namespace hindsight {
namespace {

constexpr float kHazeRange_m = 45.0F;
constexpr float kSensorNoise = 2.5F;
constexpr std::size_t kSensorNoiseTable = 65536;
constexpr float kSun[3] = {-0.4F, 0.5F, 0.77F};
/// Of the ground's texture, from clearings down to blades.
constexpr float kGroundLengths_m[] = {5.3F, 1.9F, 0.71F, 0.27F, 0.101F, 0.039F};
constexpr float kGroundWeights[] = {0.30F, 0.35F, 0.40F, 0.45F, 0.45F, 0.40F};
constexpr float kDepthLimit = 1e9F;

/// How much is left of texture of a certain length where a pixel covers `footprint_m` of it.
float visible(float length_m, float footprint_m) {
  return std::clamp(1.5F - 2.0F * footprint_m / length_m, 0.0F, 1.0F);
}

/// As std::floor, which is a call on x86 without SSE 4.1.
int floor_of(float x) {
  const int truncated = static_cast<int>(x);
  return truncated - (x < static_cast<float>(truncated) ? 1 : 0);
}

float smooth(float t) { return t * t * (3.0F - 2.0F * t); }

float mix(float a, float b, float t) { return a + (b - a) * t; }

}  // namespace

ValueNoise::ValueNoise(std::uint64_t seed) : table_(kSide * kSide) {
  DemoRandom random(seed);
  for (float& value : table_) value = static_cast<float>(random.uniform(-1.0, 1.0));
}

float ValueNoise::at(float x, float y) const {
  const int column = floor_of(x), row = floor_of(y);
  const float u = smooth(x - static_cast<float>(column)), v = smooth(y - static_cast<float>(row));
  constexpr int kMask = kSide - 1;
  const int left = column & kMask, right = (column + 1) & kMask;
  const int top = row & kMask, bottom = (row + 1) & kMask;
  const auto value = [this](int i, int j) { return table_[static_cast<std::size_t>(j * kSide + i)]; };
  return mix(mix(value(left, top), value(right, top), u), mix(value(left, bottom), value(right, bottom), u),
             v);
}

DemoScene::DemoScene(const DemoWorld& world, const DemoCamera& camera, std::uint64_t seed)
    : world_(world),
      camera_(camera),
      noise_(seed),
      rays_(static_cast<std::size_t>(camera.width_px) * static_cast<std::size_t>(camera.height_px)),
      depth_(rays_.size()),
      colors_(rays_.size()),
      sensor_noise_(kSensorNoiseTable),
      bgr_(rays_.size() * 3),
      noise_state_(seed) {
  DemoRandom random(seed + 1);
  for (float& value : sensor_noise_) value = kSensorNoise * static_cast<float>(random.normal());
  cast_rays();
}

void DemoScene::cast_rays() {
  for (int row = 0; row < camera_.height_px; ++row) {
    for (int column = 0; column < camera_.width_px; ++column) {
      const double c[3] = {(column - camera_.cx_px) / camera_.fx_px, (row - camera_.cy_px) / camera_.fy_px,
                           1.0};
      double b[3];
      for (std::size_t i = 0; i < 3; ++i) {
        b[i] = camera_.R_BC[3 * i] * c[0] + camera_.R_BC[3 * i + 1] * c[1] + camera_.R_BC[3 * i + 2] * c[2];
      }
      Ray& ray = rays_[static_cast<std::size_t>(row * camera_.width_px + column)];
      ray = {static_cast<float>(b[0]), static_cast<float>(b[1]), static_cast<float>(b[2]), 0.0F};
      if (b[2] < -1e-3) ray.ground_depth = static_cast<float>(-camera_.p_BC_m[2] / b[2]);
    }
  }
}

std::span<const std::uint8_t> DemoScene::render(const DemoPose& X_WB) {
  draw_ground(X_WB);
  const double c = std::cos(X_WB.heading_rad), s = std::sin(X_WB.heading_rad);
  for (std::size_t i = 0; i < world_.trees.size(); ++i) {
    const DemoTree& tree = world_.trees[i];
    const double dx = tree.x_m - X_WB.x_m, dy = tree.y_m - X_WB.y_m;
    draw_tree({static_cast<float>(c * dx + s * dy - camera_.p_BC_m[0]),
               static_cast<float>(-s * dx + c * dy - camera_.p_BC_m[1]), static_cast<float>(tree.radius_m),
               static_cast<float>(tree.trunk_m - camera_.p_BC_m[2]), static_cast<float>(tree.crown_m),
               static_cast<float>(i) * 7.3F});
  }
  add_sensor_noise();
  return bgr_;
}

DemoScene::Color DemoScene::in_haze(Color color, float distance_m) const {
  const float left = std::exp(-distance_m / kHazeRange_m);
  return {mix(215.0F, color.b, left), mix(205.0F, color.g, left), mix(195.0F, color.r, left)};
}

DemoScene::Color DemoScene::sky(const Ray& ray) const {
  const float up = std::clamp(ray.z / std::hypot(ray.x, ray.y) * 3.0F, 0.0F, 1.0F);
  return {mix(215.0F, 235.0F, up), mix(205.0F, 185.0F, up), mix(195.0F, 140.0F, up)};
}

DemoScene::Color DemoScene::ground(float x_m, float y_m, float distance_m) const {
  // A pixel covers more of the ground lengthwise than across: their geometric mean stands for both.
  const auto height_m = static_cast<float>(camera_.p_BC_m[2]);
  const float footprint_m =
      distance_m / static_cast<float>(camera_.fx_px) * std::sqrt(std::max(1.0F, distance_m / height_m));
  float grass = 0.0F;
  float light = 0.0F;
  for (std::size_t k = 0; k < std::size(kGroundLengths_m); ++k) {
    const float length_m = kGroundLengths_m[k];
    const float share = visible(length_m, footprint_m) * kGroundWeights[k];
    if (share <= 0.0F) break;
    const auto offset = 17.7F * static_cast<float>(k);
    const float value = share * noise_.at(x_m / length_m + offset, y_m / length_m - offset);
    (k < 3 ? grass : light) += value;
  }
  const float green = std::clamp(0.6F + 0.7F * grass, 0.0F, 1.0F);
  Color color{mix(85.0F, 48.0F, green), mix(135.0F, 128.0F, green), mix(150.0F, 88.0F, green)};
  const auto mud_x = static_cast<float>(world_.mud.x_m), mud_y = static_cast<float>(world_.mud.y_m);
  const float from_mud_m = std::hypot(x_m - mud_x, y_m - mud_y) + 0.3F * grass;
  if (from_mud_m < static_cast<float>(world_.mud.radius_m)) color = {60.0F, 68.0F, 74.0F};
  const float brightness = 1.0F + 0.55F * light;
  return {color.b * brightness, color.g * brightness, color.r * brightness};
}

void DemoScene::draw_ground(const DemoPose& X_WB) {
  const auto c = static_cast<float>(std::cos(X_WB.heading_rad)),
             s = static_cast<float>(std::sin(X_WB.heading_rad));
  const auto x_m = static_cast<float>(X_WB.x_m), y_m = static_cast<float>(X_WB.y_m);
  const auto camera_x = static_cast<float>(camera_.p_BC_m[0]),
             camera_y = static_cast<float>(camera_.p_BC_m[1]);
  for (std::size_t i = 0; i < rays_.size(); ++i) {
    const Ray& ray = rays_[i];
    depth_[i] = kDepthLimit;
    if (ray.ground_depth <= 0.0F) {
      colors_[i] = sky(ray);
      continue;
    }
    depth_[i] = ray.ground_depth;
    const float dx = ray.x * ray.ground_depth, dy = ray.y * ray.ground_depth;
    const float distance_m = std::sqrt(dx * dx + dy * dy);
    const float bx = dx + camera_x, by = dy + camera_y;
    colors_[i] = in_haze(ground(x_m + c * bx - s * by, y_m + s * bx + c * by, distance_m), distance_m);
  }
}

void DemoScene::draw_tree(const Upright& tree) {
  const auto height_m = static_cast<float>(camera_.p_BC_m[2]);
  draw_trunk(tree, box_around(tree, tree.radius_m, -height_m, tree.middle_m));
  draw_crown(tree,
             box_around(tree, tree.crown_m, tree.middle_m - tree.crown_m, tree.middle_m + tree.crown_m));
}

/// Around the picture of an upright box, generously; empty behind the camera.
DemoScene::Box DemoScene::box_around(const Upright& tree, float half_width_m, float low_m,
                                     float high_m) const {
  const auto& R = camera_.R_BC;
  double left = camera_.width_px, right = 0.0, top = camera_.height_px, bottom = 0.0;
  int behind = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const double b[3] = {tree.x_m + ((corner & 1) != 0 ? half_width_m : -half_width_m),
                         tree.y_m + ((corner & 2) != 0 ? half_width_m : -half_width_m),
                         (corner & 4) != 0 ? high_m : low_m};
    double c[3];
    for (std::size_t i = 0; i < 3; ++i) c[i] = R[i] * b[0] + R[3 + i] * b[1] + R[6 + i] * b[2];
    if (c[2] < 0.05) {
      ++behind;
      continue;
    }
    const double x_px = camera_.cx_px + camera_.fx_px * c[0] / c[2],
                 y_px = camera_.cy_px + camera_.fy_px * c[1] / c[2];
    left = std::min(left, x_px), right = std::max(right, x_px);
    top = std::min(top, y_px), bottom = std::max(bottom, y_px);
  }
  if (behind == 8) return {0, 0, 0, 0};
  if (behind > 0) return {0, 0, camera_.width_px, camera_.height_px};
  const auto within = [](double value, int most) {
    return static_cast<int>(std::clamp<double>(value, 0.0, most));
  };
  return {within(left - 1.0, camera_.width_px), within(top - 1.0, camera_.height_px),
          within(right + 2.0, camera_.width_px), within(bottom + 2.0, camera_.height_px)};
}

/// An upright cylinder: a circle in the plan.
void DemoScene::draw_trunk(const Upright& tree, const Box& box) {
  const auto height_m = static_cast<float>(camera_.p_BC_m[2]);
  const float outside = tree.x_m * tree.x_m + tree.y_m * tree.y_m - tree.radius_m * tree.radius_m;
  for (int row = box.top; row < box.bottom; ++row) {
    for (int column = box.left; column < box.right; ++column) {
      const auto i = static_cast<std::size_t>(row * camera_.width_px + column);
      const Ray& ray = rays_[i];
      const float a = ray.x * ray.x + ray.y * ray.y;
      const float half_b = ray.x * tree.x_m + ray.y * tree.y_m;
      const float discriminant = half_b * half_b - a * outside;
      if (half_b <= 0.0F || discriminant < 0.0F) continue;
      const float depth = (half_b - std::sqrt(discriminant)) / a;
      const float z_m = ray.z * depth;
      if (depth <= 0.0F || depth >= depth_[i] || z_m > tree.middle_m) continue;
      depth_[i] = depth;
      const float distance_m = depth * std::sqrt(a);
      const float nx = (ray.x * depth - tree.x_m) / tree.radius_m,
                  ny = (ray.y * depth - tree.y_m) / tree.radius_m;
      colors_[i] = in_haze(bark(tree, nx, ny, z_m + height_m, distance_m), distance_m);
    }
  }
}

void DemoScene::draw_crown(const Upright& tree, const Box& box) {
  const float outside =
      tree.x_m * tree.x_m + tree.y_m * tree.y_m + tree.middle_m * tree.middle_m - tree.crown_m * tree.crown_m;
  for (int row = box.top; row < box.bottom; ++row) {
    for (int column = box.left; column < box.right; ++column) {
      const auto i = static_cast<std::size_t>(row * camera_.width_px + column);
      const Ray& ray = rays_[i];
      const float a = ray.x * ray.x + ray.y * ray.y + ray.z * ray.z;
      const float half_b = ray.x * tree.x_m + ray.y * tree.y_m + ray.z * tree.middle_m;
      const float discriminant = half_b * half_b - a * outside;
      if (half_b <= 0.0F || discriminant < 0.0F) continue;
      const float depth = (half_b - std::sqrt(discriminant)) / a;
      if (depth <= 0.0F || depth >= depth_[i]) continue;
      depth_[i] = depth;
      const float distance_m = depth * std::sqrt(a);
      const float nx = (ray.x * depth - tree.x_m) / tree.crown_m,
                  ny = (ray.y * depth - tree.y_m) / tree.crown_m;
      const float nz = (ray.z * depth - tree.middle_m) / tree.crown_m;
      colors_[i] = in_haze(leaves(tree, nx, ny, nz, distance_m), distance_m);
    }
  }
}

DemoScene::Color DemoScene::bark(const Upright& tree, float nx, float ny, float z_m, float distance_m) const {
  const float footprint_m = distance_m / static_cast<float>(camera_.fx_px);
  const float around_m = std::atan2(ny, nx) * tree.radius_m;
  // Streaks run upwards.
  const float coarse = visible(0.06F, footprint_m) * noise_.at(around_m / 0.06F + tree.bark, z_m / 0.30F);
  const float fine = visible(0.015F, footprint_m) * noise_.at(around_m / 0.015F - tree.bark, z_m / 0.05F);
  const float sun = std::max(0.0F, nx * kSun[0] + ny * kSun[1]);
  const float brightness = (0.75F + 0.45F * sun) * (1.0F + 0.35F * coarse + 0.30F * fine);
  return {42.0F * brightness, 58.0F * brightness, 84.0F * brightness};
}

DemoScene::Color DemoScene::leaves(const Upright& tree, float nx, float ny, float nz,
                                   float distance_m) const {
  const float footprint_m = distance_m / static_cast<float>(camera_.fx_px);
  const float u = (std::atan2(ny, nx) + tree.bark) * tree.crown_m, v = nz * tree.crown_m;
  const float coarse = visible(0.3F, footprint_m) * noise_.at(u / 0.3F, v / 0.3F);
  const float fine = visible(0.06F, footprint_m) * noise_.at(u / 0.06F, v / 0.06F);
  const float sun = std::max(0.0F, nx * kSun[0] + ny * kSun[1] + nz * kSun[2]);
  const float brightness = (0.6F + 0.6F * sun) * (1.0F + 0.4F * coarse + 0.5F * fine);
  return {25.0F * brightness, 75.0F * brightness, 45.0F * brightness};
}

void DemoScene::add_sensor_noise() {
  DemoRandom random(noise_state_++);
  const auto width = static_cast<std::size_t>(camera_.width_px);
  std::size_t at = 0;
  for (std::size_t i = 0; i < colors_.size(); ++i) {
    if (i % width == 0) at = random.next() % kSensorNoiseTable;
    const float channels[3] = {colors_[i].b, colors_[i].g, colors_[i].r};
    for (std::size_t c = 0; c < 3; ++c) {
      const float value = channels[c] + sensor_noise_[at++ % kSensorNoiseTable];
      bgr_[3 * i + c] = static_cast<std::uint8_t>(std::clamp(value + 0.5F, 0.0F, 255.0F));
    }
  }
}

}  // namespace hindsight
