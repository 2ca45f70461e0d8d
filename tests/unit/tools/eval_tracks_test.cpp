// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <random>
#include <string>

#include "config/exit_code.h"
#include "tools/eval_tracks_score.h"

namespace hindsight::tools {
namespace {

class TruthFile {
 public:
  explicit TruthFile(const std::string& text)
      : path_(std::filesystem::path(testing::TempDir()) /
              ("tracks_truth_" + std::to_string(::getpid()) + ".txt")) {
    std::ofstream(path_) << text;
  }
  ~TruthFile() { std::filesystem::remove(path_); }
  TrackTruth read(double scale, int frames) const { return read_track_truth(path_, scale, frames); }

 private:
  std::filesystem::path path_;
};

Track track(int id, float x, float y) {
  Track t;
  t.id = id, t.at_px = {x, y};
  return t;
}

TEST(TrackTruth, ReadsOneBoxALineWithGaps) {
  const TrackTruth truth = TruthFile("551,233,41,82\nNaN,NaN,NaN,NaN\n540,236,39,82\n").read(0.5, 3);
  EXPECT_FALSE(truth.complete);
  ASSERT_EQ(truth.frames.size(), 3U);
  EXPECT_TRUE(truth.frames[1].empty());
  EXPECT_EQ(truth.frames[2][0].box_px, cv::Rect2d(270, 118, 19.5, 41));
}

TEST(TrackTruth, ReadsAllObjectsByFrame) {
  const TrackTruth truth = TruthFile("2,7,10,20,30,40,1,-1,-1,-1\n1,8,0,0,5,5,0\n").read(1.0, 3);
  EXPECT_TRUE(truth.complete);
  ASSERT_EQ(truth.frames.size(), 3U);
  EXPECT_FALSE(truth.frames[0][0].counts);
  EXPECT_EQ(truth.frames[1][0].id, 7);
}

TEST(TrackTruth, NothingMovesWhereTheFileIsEmptyOrNothingButNan) {
  EXPECT_TRUE(TruthFile("").read(1.0, 4).complete);
  EXPECT_TRUE(TruthFile("NaN,NaN,NaN,NaN\nnan,nan,nan,nan\n").read(1.0, 2).complete);
  EXPECT_EQ(TruthFile("").read(1.0, 4).frames.size(), 4U);
}

TEST(TrackTruth, SaysWhatIsWrongAndWhere) {
  for (const char* text : {"1,2,3\n", "1,2,3,4\n5,6,x,8\n", "1,1,2,3,4,5\n1,2,3,4\n", "0,1,2,3,4,5\n"}) {
    try {
      TruthFile(text).read(1.0, 2);
      FAIL() << text;
    } catch (const FatalError& error) {
      EXPECT_EQ(error.code(), kExitBadData);
      EXPECT_NE(std::string(error.what()).find(std::to_string(::getpid()) + ".txt:"), std::string::npos);
    }
  }
}

TEST(TrackTruth, FramesWithoutALineAreNotJudged) {
  const TrackTruth truth = TruthFile("10,10,5,5\n").read(1.0, 3);
  TrackScore score(truth, 0);
  for (int i = 0; i < 3; ++i) score.add(std::vector<Track>{});
  EXPECT_EQ(score.figures().frames, 1);
  EXPECT_EQ(*score.figures().recall, 0.0);
}

TEST(TrackScore, CountsAsTheThesisDoes) {
  TrackTruth truth;
  truth.complete = true;
  const TrueBox a{1, {0, 0, 20, 20}, true}, b{2, {100, 0, 20, 20}, true}, stands{3, {200, 0, 20, 20}, false};
  truth.frames = {{a, b}, {a, b}, {a, b, stands}, {}, {}};
  TrackScore score(truth, 0);
  score.add(std::vector{track(1, 10, 10)});  // a; b missed
  score.add(
      std::vector{track(1, 24, 10), track(2, 110, 10), track(3, 300, 300)});  // circle touches a; one false
  score.add(
      std::vector{track(4, 10, 10), track(2, 110, 10), track(5, 210, 10)});  // a under another number; spared
  score.add(std::vector<Track>{});
  score.add(std::vector{track(3, 300, 300)});
  const TrackFigures f = score.figures();
  EXPECT_EQ(f.tp, 5);
  EXPECT_EQ(f.fn, 1);
  EXPECT_EQ(f.fp, 2);
  EXPECT_EQ(f.tn, 1);
  EXPECT_EQ(f.id_switches, 1);
  EXPECT_DOUBLE_EQ(f.accuracy(), 3.0 / 6.0);
  EXPECT_DOUBLE_EQ(f.mota(), 1.0 - 4.0 / 6.0);
  EXPECT_DOUBLE_EQ(f.idf1, 2.0 * 4.0 / (7.0 + 6.0));
  EXPECT_DOUBLE_EQ(f.false_tracks_per_100_frames, 100.0 / 5.0);
}

/// A car's shadow lies under it: what does not count must not hide a second track over the car.
TEST(TrackScore, ATrackOverAShadowIsSparedButNotASecondOneOverTheObject) {
  TrackTruth truth;
  truth.complete = true;
  const TrueBox car{1, {0, 0, 20, 20}, true}, shadow{1, {0, 0, 60, 20}, false};
  truth.frames = {{car, shadow}};
  TrackScore score(truth, 0);
  score.add(std::vector{track(1, 10, 10), track(2, 12, 10), track(3, 50, 10)});
  EXPECT_EQ(score.figures().tp, 1);
  EXPECT_EQ(score.figures().fp, 1);
}

TEST(TrackScore, TheBestAssignmentIsThatOfAllPermutations) {
  std::mt19937 random(40);
  for (int round = 0; round < 50; ++round) {
    const std::size_t rows = 1 + random() % 5, columns = 1 + random() % 5;
    std::vector<std::vector<double>> values(rows, std::vector<double>(columns));
    for (auto& row : values) {
      for (double& v : row) v = static_cast<double>(random() % 20);
    }
    std::vector<std::size_t> order(std::max(rows, columns));
    std::iota(order.begin(), order.end(), std::size_t{0});
    double best = 0.0;
    do {
      double sum = 0.0;
      for (std::size_t i = 0; i < rows; ++i) sum += order[i] < columns ? values[i][order[i]] : 0.0;
      best = std::max(best, sum);
    } while (std::next_permutation(order.begin(), order.end()));
    EXPECT_EQ(best_assignment(values), best) << round;
  }
}

}  // namespace
}  // namespace hindsight::tools
