// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/training_events.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include "perception/evidence_grid.h"
#include "perception/ground_plane.h"

namespace hindsight {
namespace {

constexpr int kHistory = 200;

CameraModel shipped_camera() {
  return read_camera_model(std::filesystem::path(HINDSIGHT_SOURCE_DIR) / "config/camera.yaml");
}

struct Drive {
  CameraModel camera = shipped_camera();
  TrainingEventParams params;
  VehicleParams vehicle;
  TrainingEventSource source{params, camera, vehicle, kHistory};
  TrainingInput input;

  std::vector<TrainingEvent> tick() {
    input.new_frame = true;
    const auto events = source.update(input);
    return {events.begin(), events.end()};
  }
  std::vector<TrainingEvent> forward(double distance_m, double step_m = 0.1) {
    std::vector<TrainingEvent> all;
    for (int n = 0; n < std::lround(distance_m / step_m); ++n) {
      const Point2 p = input.X_WB * Point2{step_m, 0};
      input.X_WB = {p.x_m, p.y_m, input.X_WB.heading_rad};
      for (const TrainingEvent& e : tick()) all.push_back(e);
    }
    return all;
  }
};

ImagePoint middle(const ImageRect& r) {
  return {r.x_px + r.width_px / 2 - 0.5, r.y_px + r.height_px / 2 - 0.5};
}

TEST(TrainingEvents, BumperMeansTheTopOfAConeOnItsSide) {
  for (const bool left : {true, false}) {
    Drive drive;
    drive.tick();
    drive.input.X_WB = {10, 20, M_PI / 2};
    (left ? drive.input.bumper_left : drive.input.bumper_right) = true;
    const auto events = drive.tick();
    ASSERT_EQ(events.size(), 1U);
    EXPECT_EQ(events[0].cause, left ? TrainingCause::bumper_left : TrainingCause::bumper_right);
    EXPECT_EQ(events[0].label, TerrainClass::lethal);
    EXPECT_EQ(events[0].frames_back, 0);
    ASSERT_TRUE(events[0].in_view);
    const ImageRect r = events[0].patch_px;
    EXPECT_EQ(middle(r).x_px < 359.5, left) << "left in the picture is the left bumper";
    const auto top = drive.camera.project({0.45, left ? 0.2 : -0.2, 0.7}),
               waist = drive.camera.project({0.45, left ? 0.2 : -0.2, 0.35});
    EXPECT_NEAR(r.y_px, top->y_px, 1.5);
    EXPECT_NEAR(r.y_px + r.height_px, std::min(480.0, waist->y_px), 1.5);
    // Heading north: ahead is +y of W, left is -x.
    EXPECT_NEAR(events[0].p_WP_m.y_m, 20.45, 1e-9);
    EXPECT_NEAR(events[0].p_WP_m.x_m, left ? 9.8 : 10.2, 1e-9);
  }
}

TEST(TrainingEvents, BothBumpersMeanWhatStandsBetweenThem) {
  for (const bool at_once : {true, false}) {
    Drive drive;
    drive.tick();
    drive.input.bumper_left = true;
    if (!at_once) drive.tick();
    drive.input.bumper_right = true;
    const auto events = drive.tick();
    ASSERT_EQ(events.size(), 1U);
    EXPECT_EQ(events[0].cause, TrainingCause::bumper_both);
    EXPECT_EQ(events[0].label, TerrainClass::lethal);
    ASSERT_TRUE(events[0].in_view);
    EXPECT_NEAR(middle(events[0].patch_px).x_px, 359.5, 1.0);
    EXPECT_NEAR(events[0].p_WP_m.x_m, 0.45, 1e-9);
    EXPECT_NEAR(events[0].p_WP_m.y_m, 0.0, 1e-9);
  }
}

TEST(TrainingEvents, OneContactIsOneEvent) {
  Drive drive;
  drive.input.bumper_left = true;
  EXPECT_EQ(drive.tick().size(), 1U);
  for (int n = 0; n < 5; ++n) EXPECT_TRUE(drive.tick().empty());
  drive.input.bumper_right = true;
  EXPECT_EQ(drive.tick().size(), 1U) << "the other half is another contact";
  drive.input.bumper_left = false;
  EXPECT_TRUE(drive.tick().empty());
  drive.input.bumper_left = true;
  EXPECT_EQ(drive.tick().size(), 1U);
}

TEST(TrainingEvents, InfraredTellsTheSpotAtItsRangeOnce) {
  Drive drive;
  drive.tick();
  drive.input.ir_left_m = 0.61;
  EXPECT_TRUE(drive.tick().empty());
  drive.input.ir_left_m = 0.5;
  const auto events = drive.tick();
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].cause, TrainingCause::ir_left);
  EXPECT_EQ(events[0].label, TerrainClass::bad);
  EXPECT_NEAR(events[0].p_WP_m.x_m, 0.35 + 0.5, 1e-9);
  EXPECT_NEAR(events[0].p_WP_m.y_m, 0.25, 1e-9);
  ASSERT_TRUE(events[0].in_view);
  const auto spot = drive.camera.project({0.85, 0.25, 0.4});
  EXPECT_NEAR(middle(events[0].patch_px).x_px, spot->x_px, 5);
  EXPECT_NEAR(middle(events[0].patch_px).y_px, spot->y_px, 5);

  for (const double range_m : {0.4, 0.7, 0.55, double(NAN), 0.55}) {
    drive.input.ir_left_m = range_m;
    EXPECT_TRUE(drive.tick().empty()) << range_m << ": not armed again yet";
  }
  drive.input.ir_left_m = INFINITY;
  EXPECT_TRUE(drive.tick().empty());
  drive.input.ir_left_m = 0.55;
  EXPECT_EQ(drive.tick().size(), 1U);
}

TEST(TrainingEvents, SlipMeansTheGroundJustAhead) {
  Drive drive;
  drive.tick();
  drive.input.slip = true;
  const auto events = drive.tick();
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].cause, TrainingCause::slip);
  EXPECT_EQ(events[0].label, TerrainClass::bad);
  ASSERT_TRUE(events[0].in_view);
  EXPECT_GT(events[0].patch_px.y_px, 240);
  EXPECT_TRUE(drive.tick().empty());
}

TEST(TrainingEvents, DrivenOverGroundIsGoodAsItWasSeen) {
  Drive drive;
  const auto events = drive.forward(10.0);
  ASSERT_GE(events.size(), 8U);
  ASSERT_LE(events.size(), 10U);
  for (std::size_t n = 0; n < events.size(); ++n) {
    EXPECT_EQ(events[n].cause, TrainingCause::driven_over);
    EXPECT_EQ(events[n].label, TerrainClass::good);
    ASSERT_TRUE(events[n].in_view);
    // Seen 1.35 m ahead of the axle, driven there in steps of 0.1 m.
    EXPECT_EQ(events[n].frames_back, 14);
    const auto seen = ground_point(drive.camera, middle(events[n].patch_px));
    EXPECT_NEAR(seen->x_m, 1.35, 0.1);
    EXPECT_NEAR(seen->y_m, 0.0, 0.02);
    EXPECT_NEAR(events[n].p_WP_m.x_m - events[0].p_WP_m.x_m, 1.05 * static_cast<double>(n), 0.5);
  }
}

TEST(TrainingEvents, GroundThatWasTouchedIsNotGood) {
  Drive drive;
  drive.forward(0.5);
  drive.input.bumper_right = true;
  drive.tick();
  drive.input.bumper_right = false;
  const auto events = drive.forward(1.4);
  EXPECT_TRUE(events.empty()) << "what was seen before the contact is given up";
  EXPECT_FALSE(drive.forward(3.0).empty());
}

TEST(TrainingEvents, GroundPassedAtTheSideOrTooLateIsNotGood) {
  Drive beside;
  beside.forward(0.1);
  beside.input.X_WB = {3.0, 2.0, 0};  // past the strip, but beside it
  EXPECT_TRUE(beside.tick().empty());

  Drive late;
  late.forward(0.1);
  for (int n = 0; n < kHistory; ++n) EXPECT_TRUE(late.tick().empty());
  late.input.X_WB = {1.5, 0, 0};
  EXPECT_TRUE(late.tick().empty()) << "its frame is no longer held";
}

TEST(TrainingEvents, ClearForgetsWhatWasSeen) {
  Drive drive;
  drive.forward(0.5);
  drive.source.clear();
  EXPECT_TRUE(drive.forward(1.0).empty());
}

TEST(TrainingEvents, OutOfViewStillMarksTheGround) {
  Drive drive;
  drive.camera.set_orientation(0, -0.5, 0);  // looks at the sky
  drive.source = TrainingEventSource(drive.params, drive.camera, drive.vehicle, kHistory);
  drive.tick();
  drive.input.bumper_left = true;
  const auto events = drive.tick();
  ASSERT_EQ(events.size(), 1U);
  EXPECT_FALSE(events[0].in_view);
  EXPECT_EQ(events[0].patch_px, ImageRect{});
  EXPECT_NEAR(events[0].p_WP_m.x_m, 0.45, 1e-9);
  drive.input.bumper_left = false;
  EXPECT_TRUE(drive.forward(5.0).empty()) << "and ground that was not seen teaches nothing";
}

TEST(TrainingEvents, PatchesGivenByHandWin) {
  Drive drive;
  drive.camera.patches[std::size_t(NearPatch::bumper_left)] = ImageRect{1, 2, 30, 40};
  drive.camera.patches[std::size_t(NearPatch::ahead)] = ImageRect{340, 400, 40, 40};
  drive.source = TrainingEventSource(drive.params, drive.camera, drive.vehicle, kHistory);
  const auto good = drive.forward(3.0);
  ASSERT_FALSE(good.empty());
  EXPECT_EQ(good[0].patch_px, (ImageRect{340, 400, 40, 40}));
  const auto ahead = ground_point(drive.camera, {359.5, 419.5});
  EXPECT_NEAR(good[0].p_WP_m.x_m, 0.1 + ahead->x_m, 1e-6)
      << "the ground that the region shows, from the first pose";
  drive.input.bumper_left = true;
  EXPECT_EQ(drive.tick()[0].patch_px, (ImageRect{1, 2, 30, 40}));
}

TEST(TrainingEvents, EventsMarkTheGrid) {
  Drive drive;
  EvidenceGrid grid{EvidenceGridParams{}};
  const auto cost_after = [&](TrainingCause cause, TerrainClass label) {
    TrainingEvent event;
    event.cause = cause;
    event.label = label;
    event.p_WP_m = {1.05, -0.3};
    mark_event(event, drive.params, grid);
    return grid.cost(grid.window().cell_at(1.05, -0.3));
  };
  EXPECT_EQ(cost_after(TrainingCause::slip, TerrainClass::bad), CellCost::high);
  EXPECT_EQ(cost_after(TrainingCause::driven_over, TerrainClass::good), CellCost::none);
  EXPECT_EQ(cost_after(TrainingCause::bumper_left, TerrainClass::lethal), CellCost::lethal);
  EXPECT_EQ(cost_after(TrainingCause::driven_over, TerrainClass::good), CellCost::lethal)
      << "what was touched stays";
}

}  // namespace
}  // namespace hindsight
