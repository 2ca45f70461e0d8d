// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/aerial_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "sim_replay/world/random.h"
#include "tools/aerial_sprites.h"

namespace hindsight::tools {
namespace {

constexpr double kGround_m = 2.0 * AerialWorld::kHalf_m;
constexpr double kTexel_m = 0.05;
constexpr double kSensorNoise = 2.0;  ///< [grey levels]
constexpr double kSeen = 0.34;
constexpr int kFewestPx = 12;

cv::Vec3d lifted(cv::Point2d p, double z) { return {p.x, p.y, z}; }

cv::Point2d pixel(const cv::Matx34d& P, const cv::Vec3d& p) {
  const cv::Vec3d x = P * cv::Vec4d(p[0], p[1], p[2], 1.0);
  return {x[0] / x[2], x[1] / x[2]};
}

}  // namespace

AerialRenderer::AerialRenderer(const AerialWorld& world) {
  make_sprites(world.seed);
  draw_ground_texture(world);
  for (std::size_t i = 0; i < world.buildings.size(); ++i) {
    const AerialBuilding& b = world.buildings[i];
    add_box(statics_, b.centre_m, b.size_m, b.turn_rad, 0.0, b.height_m, roofs_[i % roofs_.size()], wall_, 0);
  }
  for (std::size_t i = 0; i < world.trees.size(); ++i) {
    const AerialTree& tree = world.trees[i];
    for (const double part : {1.0, 0.7}) {
      const double z = tree.height_m + (1.0 - part) * 2.0, r = part * tree.radius_m;
      const cv::Point2d c = tree.centre_m;
      statics_.push_back({{lifted(c + cv::Point2d(-r, r), z), lifted(c + cv::Point2d(r, r), z),
                           lifted(c + cv::Point2d(r, -r), z), lifted(c + cv::Point2d(-r, -r), z)},
                          &crowns_[i % crowns_.size()],
                          0});
    }
  }
  for (std::size_t i = 0; i < world.parked.size(); ++i) {
    add_box(statics_, world.parked[i].first, {4.3, 1.8}, world.parked[i].second, 0.3, 1.4,
            cars_[i % cars_.size()], car_sides_[i % cars_.size()], 0);
  }
}

void AerialRenderer::make_sprites(std::uint64_t seed) {
  cv::RNG random(seed * 977 + 5);
  noise_ = cv::Mat(2 * AerialCamera::kHeight_px, 2 * AerialCamera::kWidth_px, CV_16SC3);
  random.fill(noise_, cv::RNG::NORMAL, 0.0, kSensorNoise);
  wall_ = opaque(mottled({64, 64}, {150, 165, 175}, 9.0, 4, 16, random));
  for (int x = 6; x < 60; x += 18) cv::rectangle(wall_, {x, 18, 10, 24}, {70, 60, 50, 255}, cv::FILLED);
  shadow_ = cv::Mat(32, 64, CV_8UC4, cv::Scalar(20, 20, 20, 0));
  cv::ellipse(shadow_, {32, 16}, {28, 12}, 0, 0, 360, {20, 20, 20, 80}, cv::FILLED);
  for (int i = 0; i < 4; ++i) {
    roofs_.push_back(opaque(mottled({128, 128}, {90.0 + 25 * i, 110, 150.0 - 20 * i}, 10.0, 3, 48, random)));
    for (int k = 0; k < 5; ++k) {
      cv::rectangle(roofs_.back(), {random.uniform(5, 100), random.uniform(5, 100), 14, 10},
                    {160, 160, 165, 255}, cv::FILLED);
    }
    crowns_.push_back(round_cut(mottled({96, 96}, {40, 85, 55}, 16.0, 3, 24, random), random));
  }
  for (int i = 0; i < 8; ++i) {
    cars_.push_back(car_from_above(random));
    car_sides_.push_back(opaque(mottled({64, 16}, some_color(random) * 0.6, 8.0, 3, 8, random)));
    const cv::Scalar shirt = some_color(random);
    for (const int stride : {-7, 0, 7}) {
      people_.push_back(person_from_above(shirt, stride, false));
      cycles_.push_back(person_from_above(shirt, stride / 2, true));
    }
  }
}

void AerialRenderer::draw_ground_texture(const AerialWorld& world) {
  cv::RNG random(world.seed * 31 + 7);
  const int side = cvRound(kGround_m / kTexel_m);
  ground_ = mottled({side, side}, {70, 120, 100}, 7.0, 2, 512, random);
  const cv::Mat asphalt = mottled({side, side}, {105, 105, 108}, 4.0, 2, 64, random),
                gravel = mottled({side, side}, {135, 155, 170}, 7.0, 2, 32, random);
  const auto texel = [side](cv::Point2d p) {
    return cv::Point(cvRound(p.x / kTexel_m + 0.5 * side), cvRound(0.5 * side - p.y / kTexel_m));
  };
  cv::Mat mask(side, side, CV_8UC1, cv::Scalar(0));
  const auto lay = [&](const AerialRoute& route, double width_m) {
    for (std::size_t i = 1; i < route.points_m.size(); ++i) {
      cv::line(mask, texel(route.points_m[i - 1]), texel(route.points_m[i]), cv::Scalar(255),
               cvRound(width_m / kTexel_m));
    }
  };
  for (const AerialRoute& route : world.routes) {
    if (route.kind != MoverKind::car) lay(route, 2.4);
  }
  gravel.copyTo(ground_, mask);
  mask.setTo(0);
  for (const AerialRoute& route : world.routes) {
    if (route.kind == MoverKind::car) lay(route, 3.8);
  }
  asphalt.copyTo(ground_, mask);
  for (const double arm : world.arms_rad) {
    for (double r = 13.0; r < AerialWorld::kHalf_m; r += 3.0) {
      cv::line(ground_, texel({r * std::cos(arm), r * std::sin(arm)}),
               texel({(r + 1.2) * std::cos(arm), (r + 1.2) * std::sin(arm)}), {220, 225, 225}, 3,
               cv::LINE_AA);
    }
  }
}

void AerialRenderer::add_box(std::vector<Quad>& quads, cv::Point2d centre, cv::Size2d size, double turn,
                             double z0, double z1, const cv::Mat& top, const cv::Mat& side, int id) const {
  std::array<cv::Point2d, 4> c;
  const std::array<cv::Point2d, 4> unit{cv::Point2d{-0.5, 0.5}, {0.5, 0.5}, {0.5, -0.5}, {-0.5, -0.5}};
  for (std::size_t i = 0; i < 4; ++i)
    c[i] = centre + turned({unit[i].x * size.width, unit[i].y * size.height}, turn);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    quads.push_back({{lifted(c[i], z1), lifted(c[j], z1), lifted(c[j], z0), lifted(c[i], z0)}, &side, id});
  }
  quads.push_back({{lifted(c[0], z1), lifted(c[1], z1), lifted(c[2], z1), lifted(c[3], z1)}, &top, id});
}

void AerialRenderer::add_mover(std::vector<Quad>& quads, std::vector<Quad>& shadows, const MoverState& mover,
                               double t_s) const {
  const auto look = static_cast<std::size_t>(mover.id);
  const cv::Point2d sun(1.0, 0.7);  // where shadows of things 1.7 m high fall
  if (mover.kind == MoverKind::car) {
    add_box(quads, mover.at_m, {4.3, 1.8}, mover.heading_rad, 0.3, 1.4, cars_[look % cars_.size()],
            car_sides_[look % cars_.size()], mover.id);
  } else {
    const bool cycle = mover.kind == MoverKind::cyclist;
    const auto stride = static_cast<std::size_t>(t_s * 5.0 + mover.id) % 3;
    const cv::Mat& top = (cycle ? cycles_ : people_)[(look % 8) * 3 + stride];
    // Trousers, then shirt and head: two slices of a body are enough from above.
    add_box(quads, mover.at_m, cycle ? cv::Size2d(0.5, 0.3) : cv::Size2d(0.4, 0.4), mover.heading_rad, 0.0,
            1.3, car_sides_[look % car_sides_.size()], car_sides_[look % car_sides_.size()], mover.id);
    const cv::Size2d size = cycle ? cv::Size2d(1.7, 0.6) : cv::Size2d(0.7, 0.56);
    std::array<cv::Vec3d, 4> corners;
    const std::array<cv::Point2d, 4> unit{cv::Point2d{-0.5, 0.5}, {0.5, 0.5}, {0.5, -0.5}, {-0.5, -0.5}};
    for (std::size_t i = 0; i < 4; ++i) {
      corners[i] = lifted(
          mover.at_m + turned({unit[i].x * size.width, unit[i].y * size.height}, mover.heading_rad), 1.5);
    }
    quads.push_back({corners, &top, mover.id});
  }
  const double length = mover.kind == MoverKind::car ? 2.6 : 0.9,
               width = mover.kind == MoverKind::car ? 1.2 : 0.35;
  const double turn = mover.kind == MoverKind::car ? mover.heading_rad : std::atan2(sun.y, sun.x);
  const cv::Point2d centre = mover.at_m + 0.35 * sun;
  shadows.push_back({{lifted(centre + turned({-length, width}, turn), 0.0),
                      lifted(centre + turned({length, width}, turn), 0.0),
                      lifted(centre + turned({length, -width}, turn), 0.0),
                      lifted(centre + turned({-length, -width}, turn), 0.0)},
                     &shadow_,
                     mover.id});
}

void AerialRenderer::paint(const Quad& quad, const cv::Matx34d& projection, cv::Mat& picture,
                           cv::Mat* ids) const {
  std::array<cv::Point2f, 4> to, from;
  for (std::size_t i = 0; i < 4; ++i) to[i] = pixel(projection, quad.corners_m[i]);
  const cv::Rect roi =
      cv::boundingRect(std::vector<cv::Point2f>(to.begin(), to.end())) & cv::Rect({0, 0}, picture.size());
  if (roi.empty()) return;
  const auto w = static_cast<float>(quad.texture->cols), h = static_cast<float>(quad.texture->rows);
  from = {cv::Point2f{0, 0}, {w, 0}, {w, h}, {0, h}};
  for (cv::Point2f& p : to) p -= cv::Point2f(static_cast<float>(roi.x), static_cast<float>(roi.y));
  cv::Mat warped;
  cv::warpPerspective(*quad.texture, warped, cv::getPerspectiveTransform(from.data(), to.data()), roi.size(),
                      cv::INTER_LINEAR, cv::BORDER_CONSTANT, cv::Scalar(0, 0, 0, 0));
  for (int y = 0; y < roi.height; ++y) {
    for (int x = 0; x < roi.width; ++x) {
      const auto& s = warped.at<cv::Vec4b>(y, x);
      if (s[3] == 0) continue;
      auto& d = picture.at<cv::Vec3b>(roi.y + y, roi.x + x);
      for (int k = 0; k < 3; ++k) d[k] = static_cast<std::uint8_t>((s[3] * s[k] + (255 - s[3]) * d[k]) / 255);
      if (ids != nullptr && s[3] > 127) ids->at<int>(roi.y + y, roi.x + x) = quad.id;
    }
  }
}

AerialFrame AerialRenderer::render(const AerialCamera& camera, const AerialTraffic& traffic, double t_s,
                                   std::uint64_t noise_seed) {
  const cv::Matx34d P = camera.projection(t_s);
  const cv::Vec3d eye = camera.place_m(t_s);
  const cv::Size size(AerialCamera::kWidth_px, AerialCamera::kHeight_px);
  const double half = 0.5 * kGround_m;
  const cv::Matx33d world_of_texel(kTexel_m, 0, -half, 0, -kTexel_m, half, 0, 0, 1);
  AerialFrame frame;
  cv::warpPerspective(ground_, frame.bgr, ground_homography(P) * world_of_texel, size, cv::INTER_LINEAR,
                      cv::BORDER_REFLECT);
  std::vector<Quad> quads = statics_, shadows;
  const std::vector<MoverState> movers = traffic.at(t_s);
  for (const MoverState& mover : movers) add_mover(quads, shadows, mover, t_s);
  for (const Quad& shadow : shadows) paint(shadow, P, frame.bgr, nullptr);
  const auto distance = [&](const Quad& q) {
    const cv::Vec3d middle = 0.25 * (q.corners_m[0] + q.corners_m[1] + q.corners_m[2] + q.corners_m[3]);
    return cv::norm(middle - eye);
  };
  std::stable_sort(quads.begin(), quads.end(),
                   [&](const Quad& a, const Quad& b) { return distance(a) > distance(b); });
  cv::Mat ids(size, CV_32SC1, cv::Scalar(0)), alone(size, CV_32SC1), blank(size, CV_8UC3);
  for (const Quad& quad : quads) paint(quad, P, frame.bgr, &ids);
  for (const MoverState& mover : movers) {
    std::vector<cv::Point2f> outline;
    for (const Quad& quad : quads) {
      if (quad.id != mover.id) continue;
      for (const cv::Vec3d& corner : quad.corners_m) outline.emplace_back(pixel(P, corner));
    }
    const cv::Rect box = cv::boundingRect(outline), in_view = box & cv::Rect({0, 0}, size);
    if (in_view.empty()) continue;
    // All of it, had nothing stood before it: to know which part is seen.
    alone(in_view).setTo(0);
    for (const Quad& quad : quads) {
      if (quad.id == mover.id) paint(quad, P, blank, &alone);
    }
    const int all = cv::countNonZero(alone(in_view)), seen = cv::countNonZero(ids(in_view) == mover.id);
    if (all < kFewestPx) continue;
    const cv::Point2d middle(box.x + 0.5 * box.width, box.y + 0.5 * box.height);
    const bool counts = seen >= kSeen * all && cv::Rect2d({0, 0}, cv::Size2d(size)).contains(middle);
    frame.truth.push_back({mover.id, cv::Rect2d(box), counts});
  }
  for (const Quad& shadow : shadows) {
    std::vector<cv::Point2f> outline;
    for (const cv::Vec3d& corner : shadow.corners_m) outline.emplace_back(pixel(P, corner));
    const cv::Rect2d box = cv::boundingRect(outline);
    if (!(box & cv::Rect2d({0, 0}, cv::Size2d(size))).empty()) frame.truth.push_back({shadow.id, box, false});
  }
  Random random(noise_seed, 4);
  const auto shift = [&random](int most) { return static_cast<int>(random.uniform(0.0, most)); };
  const cv::Rect window({shift(size.width), shift(size.height)}, size);
  cv::add(frame.bgr, noise_(window), frame.bgr, cv::noArray(), CV_8UC3);
  return frame;
}

}  // namespace hindsight::tools
