// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/eval_tracks_command.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "config/exit_code.h"
#include "daemon/model_store.h"
#include "perception/activity_codec.h"
#include "perception/motion_tracker.h"
#include "perception/optical_flow.h"
#include "sim_replay/read_file.h"
#include "tools/cpu_time.h"
#include "tools/eval_tracks_score.h"
#include "tools/image_folder.h"
#include "tools/number_checks.h"
#include "tools/report_style.h"
#include "tools/report_tracks.h"
#include "tools/video_tracker.h"

namespace hindsight::tools {
namespace {

constexpr int kSettleFrames = 10;
constexpr double kVideo_hz = 10.0;

struct Options {
  std::string frames, truth, activity, learn, video;
  double scale = 1.0;
  bool json = false;
};

class Film {
 public:
  Film(const std::string& file, cv::Size size) {
    if (file.empty()) return;
    if (!writer_.open(file, cv::VideoWriter::fourcc('a', 'v', 'c', '1'), kVideo_hz, size)) {
      throw FatalError(kExitIo, file + ": cannot write a video; expected a name that ends in .mp4");
    }
  }
  void add(const cv::Mat& frame, const MotionReport& report, const std::vector<TrueBox>* boxes) {
    if (!writer_.isOpened()) return;
    cv::Mat picture = frame.clone();
    if (boxes != nullptr) {
      for (const TrueBox& box : *boxes) cv::rectangle(picture, box.box_px, kPaper.bgr(), 1);
    }
    draw_tracks(picture, report.tracks, report.features);
    cv::putText(picture, fmt::format("gap {}, noise {:.2f} px", report.gap_frames, report.compared.noise_px),
                {6, 16}, cv::FONT_HERSHEY_SIMPLEX, 0.45, kPaper.bgr(), 1, cv::LINE_AA);
    writer_.write(picture);
  }

 private:
  cv::VideoWriter writer_;
};

nlohmann::ordered_json or_null(const std::optional<double>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json to_json(const TrackFigures& figures, bool complete, double fps) {
  nlohmann::ordered_json json = {{"recall", or_null(figures.recall)},
                                 {"id_switches", figures.id_switches},
                                 {"false_tracks_per_100_frames", figures.false_tracks_per_100_frames},
                                 {"mean_error_px", or_null(figures.mean_error_px)},
                                 {"fps", fps}};
  if (!complete) return json;
  json["tp"] = figures.tp, json["tn"] = figures.tn, json["fp"] = figures.fp, json["fn"] = figures.fn;
  const bool any = figures.objects() > 0;
  json["accuracy"] = any ? nlohmann::ordered_json(figures.accuracy()) : nullptr;
  json["mota"] = any ? nlohmann::ordered_json(figures.mota()) : nullptr;
  json["idf1"] = any ? nlohmann::ordered_json(figures.idf1) : nullptr;
  return json;
}

void warn_of_scale(const TrackTruth& truth, cv::Size size, const Options& options) {
  int boxes = 0, outside = 0;
  for (const auto& frame : truth.frames) {
    for (const TrueBox& box : frame) ++boxes, outside += (cv::Rect2d({0, 0}, size) & box.box_px).empty();
  }
  if (2 * outside <= boxes || boxes == 0) return;
  fmt::print(stderr, "hindsight: {}: most boxes lie outside the pictures: is --scale {} right?\n",
             options.truth, options.scale);
}

std::shared_ptr<ActivityPrior> load_prior(const std::string& file) {
  const ActivityDecoded decoded = decode_activity(read_file<std::vector<std::uint8_t>>(file));
  if (!decoded.problem.empty()) throw FatalError(kExitBadData, file + ": " + decoded.problem);
  return std::make_shared<ActivityPrior>(*decoded.map);
}

void save(const ActivityMap& map, const std::string& file) {
  if (file.empty()) return;
  if (const std::string problem = save_atomically(file, encode_activity(map)); !problem.empty()) {
    throw FatalError(kExitIo, problem);
  }
}

int evaluate(const Options& options) {
  cv::setNumThreads(1);
  ImageFolder frames(options.frames);
  const cv::Size size = frames.read(0).size();
  const TrackTruth truth = read_track_truth(options.truth, options.scale, frames.size());
  warn_of_scale(truth, size, options);
  const OpticalFlowParams flow_params;
  OpticalFlow flow(flow_params, size.width, size.height);
  VideoTracker motion(MotionParams{}, size);
  ActivityAnchor anchor(flow_params.tracker, size.width, size.height);
  ActivityMap learned(kPictureActivity);
  ActivityLearner learner;
  if (!options.activity.empty()) motion.use(load_prior(options.activity));
  TrackScore score(truth, kSettleFrames);
  Film film(options.video, size);
  double motion_us = 0.0;
  for (int i = 0; i < frames.size(); ++i) {
    const cv::Mat frame = frames.read(i);
    const auto vectors = flow.update({frame.data, frame.total() * frame.elemSize()});
    motion_us += microseconds([&] { motion.step(vectors, anchor.H_G_image()); });
    const bool anchored = anchor.update(flow.pyramid(), flow.features(), motion.report().ego);
    if (anchored) {
      const Eigen::Matrix3d& H_G_image = anchor.H_G_image();
      learner.learn(motion.report().tracks, view_of(size, H_G_image), H_G_image, learned);
    }
    score.add(motion.report().tracks);
    const auto at = static_cast<std::size_t>(i);
    film.add(frame, motion.report(), at < truth.frames.size() ? &truth.frames[at] : nullptr);
  }
  save(learned, options.learn);
  const nlohmann::ordered_json json =
      to_json(score.figures(), truth.complete, 1e6 * frames.size() / motion_us);
  if (options.json) {
    fmt::print("{}\n", json.dump(2));
    return kExitOk;
  }
  for (const auto& [key, value] : json.items()) {
    fmt::print("{:<28} {}\n", key, value.is_null() ? "-" : fmt::format("{:.4g}", value.get<double>()));
  }
  return kExitOk;
}

}  // namespace

void add_eval_tracks(CLI::App& eval, Run& run) {
  CLI::App& app =
      *eval.add_subcommand("tracks", "how well what moves is found and followed from a moving camera");
  const auto options = std::make_shared<Options>();
  app.add_option("--frames", options->frames,
                 "folder of consecutive .jpg or .png frames, in the order of their names")
      ->required();
  app.add_option(
         "--truth", options->truth,
         "x,y,w,h a line: one of the things that move, NaN while out of view; or frame,id,x,y,w,h: all of "
         "them; empty: nothing moves")
      ->required();
  app.add_option("--scale", options->scale, "of the truth's numbers to the frames' pixels")
      ->capture_default_str()
      ->check(above_zero());
  app.add_option("--activity", options->activity,
                 "use an activity map learned from a video that began with the same view")
      ->type_name("MAP");
  app.add_option("--learn", options->learn, "write the activity map of this video")->type_name("MAP");
  app.add_option("--video", options->video, "draw the tracks into a film")->type_name("OUT.mp4");
  app.add_flag("--json", options->json, "print JSON; fps: frames a second of one core, beside the flow");
  app.callback([options, &run] { run = [options] { return evaluate(*options); }; });
}

}  // namespace hindsight::tools
