// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/experiment_activity.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "config/crc32.h"
#include "config/exit_code.h"
#include "perception/activity_registration.h"
#include "sim_replay/read_file.h"
#include "sim_replay/world/random.h"
#include "tools/activity_picture.h"
#include "tools/activity_report.h"
#include "tools/aerial_flight.h"
#include "tools/eval_tracks_score.h"
#include "tools/experiment_output.h"
#include "tools/process_pool.h"
#include "tools/video_tracker.h"

namespace hindsight::tools {
namespace {

constexpr double kPerMinute = 40.0, kHeight_m = 38.0, kTilt_rad = 0.1;
constexpr double kBegin_s = 60.0;  ///< traffic enters an empty world; by now who walks has got to its middle
constexpr int kTrainingFrames = 1200, kSettleFrames = 10;
constexpr double kSingleBefore_s = 7.0;
const cv::Size kSize(AerialCamera::kWidth_px, AerialCamera::kHeight_px);

using Json = nlohmann::ordered_json;

Eigen::Matrix3d to_eigen(const cv::Matx33d& m) {
  Eigen::Matrix3d e;
  e << m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2);
  return e;
}

Eigen::Vector2d mapped(const Eigen::Matrix3d& H, const Eigen::Vector2d& p) {
  return (H * p.homogeneous()).hnormalized();
}

/// What a training flight leaves behind.
struct Learned {
  explicit Learned() : anchor(TrackerParams{}, kSize.width, kSize.height), map(kPictureActivity) {}
  ActivityAnchor anchor;
  ActivityMap map;
  Eigen::Matrix3d H_G_ground;                          ///< truth
  std::vector<std::shared_ptr<ActivityPrior>> priors;  ///< after 5, 10 ... objects
  cv::Mat first, last;
  Eigen::Matrix3d H_G_last;
};

/// Flies until the last picture; a copy of the map is kept each time so many objects have been tracked.
void train(AerialFlight flight, Learned& learned) {
  VideoTracker tracker(MotionParams{}, kSize);
  ActivityLearner learner;
  std::size_t next = 1;
  std::int32_t objects = 0, newest = 0;
  for (int i = 0; i < kTrainingFrames; ++i) {
    const auto flow = flight.step();
    const MotionReport& report = tracker.step(flow, learned.anchor.H_G_image());
    if (i == 0) {
      learned.H_G_ground = to_eigen(flight.H_image_ground());
      flight.frame().bgr.copyTo(learned.first);
    }
    if (!learned.anchor.update(flight.flow().pyramid(), flight.flow().features(), report.ego)) continue;
    const Eigen::Matrix3d& H_G_image = learned.anchor.H_G_image();
    learner.learn(report.tracks, view_of(kSize, H_G_image), H_G_image, learned.map);
    for (const Track& track : report.tracks) {
      if (track.id > newest) newest = track.id, ++objects;
    }
    for (; next < kObjects.size() && (objects >= kObjects[next] || i + 1 == kTrainingFrames); ++next) {
      learned.priors.push_back(std::make_shared<ActivityPrior>(learned.map));
    }
  }
  flight.frame().bgr.copyTo(learned.last);
  learned.H_G_last = learned.anchor.H_G_image();
}

Json json_of(const TrackFigures& f) {
  return {{"accuracy", f.accuracy()},
          {"mota", f.mota()},
          {"idf1", f.idf1},
          {"tp", f.tp},
          {"tn", f.tn},
          {"fp", f.fp},
          {"fn", f.fn},
          {"id_switches", f.id_switches}};
}

/// One video, one tracker for each map.
std::vector<TrackFigures> test(AerialFlight flight, int frames, Learned& learned) {
  std::vector<VideoTracker> trackers;
  std::vector<std::vector<std::vector<Track>>> told(kObjects.size());
  TrackTruth truth{.complete = true, .frames = {}};
  trackers.reserve(kObjects.size());
  for (std::size_t k = 0; k < kObjects.size(); ++k) {
    trackers.emplace_back(MotionParams{}, kSize);
    if (k > 0) trackers.back().use(learned.priors[k - 1]);
  }
  learned.anchor.start_over();
  for (int i = 0; i < frames; ++i) {
    const auto flow = flight.step();
    for (std::size_t k = 0; k < trackers.size(); ++k) {
      const MotionReport& report = trackers[k].step(flow, learned.anchor.H_G_image());
      told[k].emplace_back(report.tracks.begin(), report.tracks.end());
    }
    learned.anchor.update(flight.flow().pyramid(), flight.flow().features(), trackers[0].report().ego);
    truth.frames.push_back(flight.frame().truth);
  }
  std::vector<TrackFigures> figures;
  for (const auto& tracks : told) {
    TrackScore score(truth, kSettleFrames);
    for (const auto& frame : tracks) score.add(frame);
    figures.push_back(score.figures());
  }
  return figures;
}

/// One person alone: 7 s before the person comes into view until 207 frames are full (thesis, table 3.1).
TrackFigures single_object(const AerialWorld& world, AerialRenderer& renderer, std::uint64_t seed) {
  const AerialTraffic traffic(world, seed, kPerMinute, 1, MoverKind::person);
  const AerialCamera camera(seed, {0, 0}, kHeight_m, 0.0, kTilt_rad);
  double begin_s = 0.0;
  for (; begin_s < traffic.end_s(); begin_s += 0.1) {
    bool seen = false;
    for (const MoverState& m : traffic.at(begin_s)) seen |= cv::norm(m.at_m) < 15.0;
    if (seen) break;
  }
  AerialFlight flight(renderer, camera, traffic, begin_s - kSingleBefore_s);
  VideoTracker tracker(MotionParams{}, kSize);
  TrackTruth truth{.complete = true, .frames = {}};
  std::vector<std::vector<Track>> told;
  for (int i = 0; i < kSingleFrames; ++i) {
    const MotionReport& report = tracker.step(flight.step(), Eigen::Matrix3d::Identity());
    told.emplace_back(report.tracks.begin(), report.tracks.end());
    truth.frames.push_back(flight.frame().truth);
  }
  TrackScore score(truth, kSettleFrames);
  for (const auto& tracks : told) score.add(tracks);
  return score.figures();
}

/// How far the alignment of the maps puts B's motion from where it is in A, and how far it is turned wrongly.
Json compare(const Learned& a, const Learned& b, const ActivityAlignment& found) {
  const Eigen::Matrix3d H_A_B = a.H_G_ground * b.H_G_ground.inverse();
  const double c = std::cos(found.angle_rad), s = std::sin(found.angle_rad);
  Eigen::Matrix2d R;
  R << c, -s, s, c;
  double error_cells = 0.0, turn = 0.0;
  for (const auto& cell : b.map.active()) {
    const Eigen::Vector2d p = b.map.middle_of(cell.column, cell.row);
    error_cells += (R * p + found.t - mapped(H_A_B, p)).norm() / a.map.cell();
    const Eigen::Matrix2d J = jacobian_of(H_A_B, p);
    turn += std::remainder(std::atan2(J(1, 0) - J(0, 1), J(0, 0) + J(1, 1)) - found.angle_rad, 2.0 * M_PI);
  }
  const auto n = static_cast<double>(std::max<std::size_t>(1, b.map.active().size()));
  return {{"cells", error_cells / n},
          {"degrees", std::abs(turn / n) * 180.0 / M_PI},
          {"likeness", found.likeness}};
}

bool taken_for_roundabout(const ActivityMap& map) {
  const double px_per_m = AerialCamera::kFocal_px / kHeight_m;
  const double reach = 18.0 * px_per_m, lane = 1.8 * px_per_m, speed = 0.55 * px_per_m;
  const double ring =
      register_activity(map, roundabout_template(kPictureActivity, reach, lane, speed, 8.0 * px_per_m))
          .likeness;
  return ring > register_activity(map, crossroads_template(kPictureActivity, reach, lane, speed)).likeness;
}

void draw_figures(const ExperimentOutput& output, const Learned& a, const Learned& b,
                  const ActivityAlignment& found) {
  cv::Mat map = a.last.clone();
  draw_activity(map, a.map, a.H_G_last.inverse());
  cv::imwrite(output.path("_map.png"), map);
  const double c = std::cos(found.angle_rad), s = std::sin(found.angle_rad);
  const int margin = 120;
  const cv::Size size(kSize.width + 2 * margin, kSize.height + 2 * margin);
  cv::Mat both(size, CV_8UC3, cv::Scalar(60, 60, 60)), second;
  a.first.copyTo(both(cv::Rect({margin, margin}, kSize)));
  const cv::Matx23d warp(c, -s, found.t.x() + margin, s, c, found.t.y() + margin);
  cv::warpAffine(b.first, second, warp, size, cv::INTER_LINEAR, cv::BORDER_CONSTANT);
  cv::Mat inside;
  cv::warpAffine(cv::Mat(kSize, CV_8UC1, cv::Scalar(255)), inside, warp, size);
  cv::Mat blend;
  cv::addWeighted(both, 0.5, second, 0.5, 0.0, blend);
  blend.copyTo(both, inside);
  cv::imwrite(output.path("_registration.png"), both);
}

Json work(const ActivityExperiment& experiment, const ExperimentOutput& output, int piece) {
  cv::setNumThreads(1);
  const std::uint64_t seed = experiment.seed + static_cast<std::uint64_t>(piece);
  const AerialWorld world = make_aerial_world(seed);
  AerialRenderer renderer(world);
  Random random(seed, 5);
  const auto traffic = [&](std::uint64_t which) {
    return AerialTraffic(world, 16 * seed + which, kPerMinute, 400, {});
  };
  const auto somewhere = [&](double reach_m) {
    const double x = random.uniform(-reach_m, reach_m), y = random.uniform(-reach_m, reach_m);
    return cv::Point2d(x, y);
  };
  const double yaw = random.uniform(0.0, 2.0 * CV_PI);
  const cv::Point2d over_t = somewhere(1.0), over_b = somewhere(3.0);
  const double yaw_t = yaw + random.uniform(-0.05, 0.05), yaw_b = random.uniform(0.0, 2.0 * CV_PI);
  Learned a, b;
  train(AerialFlight(renderer, AerialCamera(16 * seed + 1, {0, 0}, kHeight_m, yaw, kTilt_rad), traffic(1),
                     kBegin_s),
        a);
  const std::vector<TrackFigures> figures =
      test(AerialFlight(renderer, AerialCamera(16 * seed + 2, over_t, kHeight_m, yaw_t, kTilt_rad),
                        traffic(2), kBegin_s),
           experiment.frames, a);
  train(AerialFlight(renderer, AerialCamera(16 * seed + 3, over_b, kHeight_m, yaw_b, kTilt_rad), traffic(3),
                     kBegin_s),
        b);
  const ActivityAlignment found = register_activity(a.map, b.map);
  Json json;
  json["seed"] = seed;
  for (std::size_t k = 0; k < kObjects.size(); ++k) json["tracking"].push_back(json_of(figures[k]));
  json["single"] = json_of(single_object(world, renderer, seed));
  json["registration"] = compare(a, b, found);
  json["roundabout"] = world.roundabout, json["taken_for_roundabout"] = taken_for_roundabout(a.map);
  if (piece == 0) draw_figures(output, a, b, found);
  return json;
}

/// Of what two runs must have in common for their worlds to stand in one table: options, and the program.
Json stamp_of(const ActivityExperiment& experiment) {
  const auto program = read_file<std::vector<std::uint8_t>>("/proc/self/exe");
  return {{"frames", experiment.frames},
          {"training_frames", kTrainingFrames},
          {"objects", kObjects},
          {"program_crc32", fmt::format("{:08x}", crc32(program))}};
}

/// What an earlier run of the same experiment has flown over: it goes on where that was stopped. Lines of
/// other options, or of another build of the program, are left alone.
std::map<std::uint64_t, Json> read_flown(const ActivityExperiment& experiment, const Json& stamp,
                                         const std::string& file) {
  std::map<std::uint64_t, Json> flown;
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    const Json json = Json::parse(line, nullptr, false);
    if (json.is_discarded() || json.value("stamp", Json()) != stamp) continue;
    const auto seed = json.value("seed", std::uint64_t{0});
    if (seed - experiment.seed < static_cast<std::uint64_t>(experiment.seeds)) flown[seed] = json;
  }
  return flown;
}

}  // namespace

int run_activity_experiment(const ActivityExperiment& experiment) {
  const ExperimentOutput output(experiment.folder, "activity");
  const std::string kept = output.path("_worlds.jsonl");
  const Json stamp = stamp_of(experiment);
  std::map<std::uint64_t, Json> flown = read_flown(experiment, stamp, kept);
  std::vector<int> pieces;
  for (int i = 0; i < experiment.seeds; ++i) {
    if (!flown.contains(experiment.seed + static_cast<std::uint64_t>(i))) pieces.push_back(i);
  }
  const int failed = run_in_processes(
      static_cast<int>(pieces.size()), experiment.processes,
      [&](int i) { return work(experiment, output, pieces[static_cast<std::size_t>(i)]).dump(); },
      [&](int, const std::string& text) {
        Json json = Json::parse(text);
        json["stamp"] = stamp;
        flown[json["seed"].get<std::uint64_t>()] = json;
        std::ofstream(kept, std::ios::app) << json.dump() << "\n";
        fmt::print(stderr, "\rworld {} of {}   ", flown.size(), experiment.seeds);
      });
  if (failed > 0) throw FatalError(kExitSoftware, fmt::format("{} worlds could not be flown over", failed));
  fmt::print(stderr, "\n");
  std::vector<Json> all;
  for (const auto& [seed, json] : flown) all.push_back(json);
  report_activity(experiment, output, all);
  return kExitOk;
}

}  // namespace hindsight::tools
