// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/training_patch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "perception/texture_code.h"

namespace hindsight {
namespace {

constexpr int kWidth = 120, kHeight = 80;

struct Point {
  float x_px = 0.0F;
  float y_px = 0.0F;
};
struct Trace {
  Point point_px;
  int frames_back = 0;
  bool entered_here = false;
};

/// A vehicle that drives straight ahead: every frame back, points come closer to (60, 20) by `shrink`.
struct ZoomFlow {
  float shrink = 0.97F;
  int oldest = 50;
  Trace trace_back(Point from_px, int max_frames, int from_frames_back) const {
    Trace trace{from_px, from_frames_back, false};
    while (max_frames-- > 0 && trace.frames_back < oldest) {
      trace.point_px = {60 + shrink * (trace.point_px.x_px - 60), 20 + shrink * (trace.point_px.y_px - 20)};
      ++trace.frames_back;
    }
    return trace;
  }
};

/// Everything moves right by 3 px a frame back, and has entered where it would leave the picture.
struct ShiftFlow {
  Trace trace_back(Point from_px, int max_frames, int from_frames_back) const {
    Trace trace{from_px, from_frames_back, false};
    while (max_frames-- > 0) {
      if (trace.point_px.x_px + 3 > kWidth - 0.5F) {
        trace.entered_here = true;
        break;
      }
      trace.point_px.x_px += 3;
      ++trace.frames_back;
    }
    return trace;
  }
};

/// Pictures in which every pixel tells its frame (blue), column (green) and row (red).
AppearanceHistory telling_history(int frames, int shrink) {
  AppearanceHistory history({shrink}, frames, kWidth, kHeight);
  std::vector<std::uint8_t> picture(kWidth * kHeight * 3);
  for (int frame = frames - 1; frame >= 0; --frame) {
    for (int n = 0; n < kWidth * kHeight; ++n) {
      std::uint8_t* pixel = &picture[static_cast<std::size_t>(3 * n)];
      pixel[0] = static_cast<std::uint8_t>(frame);
      pixel[1] = static_cast<std::uint8_t>(n % kWidth / shrink * shrink);
      pixel[2] = static_cast<std::uint8_t>(n / kWidth / shrink * shrink);
    }
    history.push(picture);
  }
  return history;
}

TrainingPatchParams thesis() {
  TrainingPatchParams params;
  params.trace_until = "oldest";
  params.looks = "far";
  params.max_points = 1000000;
  return params;
}

const ImageRect kPatch{40, 40, 30, 20};

TEST(TrainingPatch, TakesEachPixelWhereItsOwnTraceEnds) {
  const AppearanceHistory history = telling_history(60, 1);
  const ShiftFlow flow;
  TrainingPatchTracer tracer(thesis());
  PatchPixels pixels;
  const TracedPatch result = tracer.trace(flow, history, kPatch, 0, pixels);
  EXPECT_EQ(result.points, 600);
  std::set<Bgr> expected;
  for (int y = 40; y < 60; ++y) {
    for (int x = 40; x < 70; ++x) {
      const int steps = (kWidth - 1 - x) / 3;
      expected.insert({std::uint8_t(steps), std::uint8_t(x + 3 * steps), std::uint8_t(y)});
    }
  }
  EXPECT_EQ(std::set<Bgr>(pixels.bgr.begin(), pixels.bgr.end()), expected);
  EXPECT_EQ(pixels.bgr.size(), expected.size()) << "no pixel twice";
}

TEST(TrainingPatch, WithoutReverseFlowThePatchAsItLooksNow) {
  const AppearanceHistory history = telling_history(60, 1);
  TrainingPatchParams params = thesis();
  params.reverse_flow = false;
  TrainingPatchTracer tracer(params);
  PatchPixels pixels;
  const TracedPatch result = tracer.trace(ZoomFlow{}, history, kPatch, 7, pixels);
  EXPECT_EQ(result.pixels, 600);
  EXPECT_EQ(result.frames_back, 7);
  EXPECT_EQ(result.there_px, kPatch);
  for (const Bgr& pixel : pixels.bgr) {
    EXPECT_EQ(pixel[0], 7);
    EXPECT_TRUE(pixel[1] >= 40 && pixel[1] < 70 && pixel[2] >= 40 && pixel[2] < 60);
  }
}

TEST(TrainingPatch, TracesToTheOldestFrame) {
  const AppearanceHistory history = telling_history(60, 1);
  TrainingPatchTracer tracer(thesis());
  PatchPixels pixels;
  const TracedPatch result = tracer.trace(ZoomFlow{}, history, kPatch, 0, pixels);
  EXPECT_EQ(result.frames_back, 50);
  EXPECT_EQ(result.points, 600);
  EXPECT_LT(result.pixels, 60) << "a patch that was small then is few pixels, each once";
  EXPECT_EQ(std::set<Bgr>(pixels.bgr.begin(), pixels.bgr.end()).size(), pixels.bgr.size());
  for (const Bgr& pixel : pixels.bgr) EXPECT_EQ(pixel[0], 50);
}

TEST(TrainingPatch, StopsWhileThePatchIsWideEnough) {
  const AppearanceHistory history = telling_history(60, 1);
  TrainingPatchParams params;
  params.looks = "far";
  TrainingPatchTracer tracer(params);
  PatchPixels pixels;
  const TracedPatch result = tracer.trace(ZoomFlow{}, history, kPatch, 3, pixels);
  const int expected = static_cast<int>(std::floor(std::log(params.min_width_px / 30.0) / std::log(0.97)));
  EXPECT_EQ(result.frames_back, 3 + expected);
  EXPECT_GE(result.there_px.width_px, params.min_width_px - 0.5);
}

TEST(TrainingPatch, LooksAtThePatchAllTheWayItCame) {
  const AppearanceHistory history = telling_history(60, 1);
  TrainingPatchParams params;
  TrainingPatchTracer tracer(params);
  PatchPixels pixels;
  const TracedPatch result = tracer.trace(ZoomFlow{}, history, kPatch, 3, pixels);
  std::set<int> frames;
  for (const Bgr& pixel : pixels.bgr) frames.insert(pixel[0]);
  // 0.97^12 is the first power below 0.7; the fourth look would be narrower than 8 px.
  EXPECT_EQ(frames, (std::set{3, 15, 27, 39}));
  EXPECT_GE(result.there_px.width_px, params.min_width_px - 0.5);

  params.looks = "far";
  TrainingPatchTracer far_tracer(params);
  far_tracer.trace(ZoomFlow{}, history, kPatch, 3, pixels);
  frames.clear();
  for (const Bgr& pixel : pixels.bgr) frames.insert(pixel[0]);
  EXPECT_EQ(frames, std::set{3 + 43});
}

TEST(TrainingPatch, ALookEndsWhereThePatchEnteredTheView) {
  const AppearanceHistory history = telling_history(60, 1);
  TrainingPatchParams params;
  params.max_points = 1000;
  TrainingPatchTracer tracer(params);
  PatchPixels pixels;
  tracer.trace(ShiftFlow{}, history, {kWidth - 10, 40, 8, 20}, 0, pixels);
  for (const Bgr& pixel : pixels.bgr)
    EXPECT_EQ(pixel[0], 0) << "its right edge was in view in no other frame";
  EXPECT_EQ(pixels.bgr.size(), 160U);
}

TEST(TrainingPatch, TellsTheTextureOfEachPixel) {
  const AppearanceHistory history = telling_history(60, 1);
  TrainingPatchTracer tracer(thesis());
  PatchPixels pixels;
  tracer.trace(ShiftFlow{}, history, kPatch, 0, pixels);
  ASSERT_EQ(pixels.texture.size(), pixels.bgr.size());
  for (std::size_t i = 0; i < pixels.bgr.size(); ++i) {
    const auto [frame, column, row] = pixels.bgr[i];
    EXPECT_EQ(pixels.texture[i], texture_code_at(history.picture(frame), kWidth, kHeight, column, row));
  }
}

TEST(TrainingPatch, PixelsThatFallTogetherInAShrunkenPictureCountOnce) {
  const AppearanceHistory history = telling_history(60, 4);
  TrainingPatchParams params = thesis();
  params.reverse_flow = false;
  TrainingPatchTracer tracer(params);
  PatchPixels pixels;
  EXPECT_EQ(tracer.trace(ZoomFlow{}, history, {40, 40, 32, 20}, 0, pixels).points, 640);
  EXPECT_EQ(pixels.bgr.size(), 40U);
}

TEST(TrainingPatch, PointsAreLimitedAndSpread) {
  const AppearanceHistory history = telling_history(60, 1);
  TrainingPatchParams params = thesis();
  params.reverse_flow = false;
  params.max_points = 100;
  TrainingPatchTracer tracer(params);
  PatchPixels pixels;
  const TracedPatch result = tracer.trace(ZoomFlow{}, history, kPatch, 0, pixels);
  EXPECT_LE(result.points, 100);
  EXPECT_GT(result.points, 50);
  EXPECT_GT(result.there_px.width_px, 25);
  EXPECT_GT(result.there_px.height_px, 15);
}

TEST(TrainingPatch, FrameThatIsNoLongerHeldTeachesNothing) {
  const AppearanceHistory history = telling_history(20, 1);
  TrainingPatchTracer tracer(thesis());
  PatchPixels pixels{std::vector<Bgr>(3), std::vector<std::uint8_t>(3)};
  EXPECT_EQ(tracer.trace(ZoomFlow{}, history, kPatch, 20, pixels).points, 0);
  EXPECT_TRUE(pixels.bgr.empty() && pixels.texture.empty());
  const TracedPatch result = tracer.trace(ZoomFlow{}, history, kPatch, 15, pixels);
  EXPECT_EQ(result.frames_back, 19) << "flow reaches farther back than pictures";
}

}  // namespace
}  // namespace hindsight
