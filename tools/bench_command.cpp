// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/bench_command.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "config/exit_code.h"
#include "tools/bench_dstar.h"
#include "tools/bench_flow.h"
#include "tools/bench_motion.h"
#include "tools/bench_reflex.h"
#include "tools/bench_render.h"
#include "tools/bench_robot.h"
#include "tools/bench_segment.h"
#include "tools/bench_templates.h"
#include "tools/builtin_config.h"
#include "tools/image_folder.h"

namespace hindsight::tools {
namespace {

const cv::Size kSize(720, 480);
constexpr int kMostFrames = 40;
constexpr int kFewFrames = 4;

struct BenchOptions {
  std::string frames;
  bool json = false;
};

std::vector<cv::Mat> read_frames(const std::string& folder, int most) {
  ImageFolder images(folder);
  std::vector<cv::Mat> frames;
  for (int i = 0; i < std::min(images.size(), most); ++i) {
    cv::Mat frame;
    cv::resize(images.read(i), frame, kSize, 0.0, 0.0, cv::INTER_AREA);
    frames.push_back(frame);
  }
  return frames;
}

/// Without pictures: coloured noise of several scales that grows as if one drove towards it.
std::vector<cv::Mat> make_frames(int count) {
  cv::RNG random(20110501);
  cv::Mat texture(1000, 1400, CV_8UC3, cv::Scalar(90, 110, 100));
  for (int cell = 4; cell <= 256; cell *= 4) {
    cv::Mat coarse(texture.rows / cell + 2, texture.cols / cell + 2, CV_16SC3);
    random.fill(coarse, cv::RNG::NORMAL, 0.0, 22.0);
    cv::Mat octave;
    cv::resize(coarse, octave, texture.size(), 0.0, 0.0, cv::INTER_CUBIC);
    cv::add(texture, octave, texture, cv::noArray(), CV_8UC3);
  }
  std::vector<cv::Mat> frames;
  for (int i = 0; i < count; ++i) {
    const double zoom = std::pow(1.02, i) * 0.9;
    const cv::Matx23d warp(zoom, 0.0, kSize.width / 2.0 - zoom * texture.cols / 2.0, 0.0, zoom,
                           kSize.height / 2.0 - zoom * texture.rows / 2.0);
    cv::Mat frame;
    cv::warpAffine(texture, frame, warp, kSize, cv::INTER_LINEAR, cv::BORDER_REFLECT);
    frames.push_back(frame);
  }
  return frames;
}

std::vector<cv::Mat> load_frames(const BenchOptions& options, int most) {
  const std::vector<cv::Mat> frames = options.frames.empty() ? make_frames(most) : read_frames(options.frames, most);
  if (frames.size() < 3) throw FatalError(kExitBadData, options.frames + ": at least 3 frames are needed");
  return frames;
}

/// A machine without OpenGL has no simulator, but all the other figures.
void add_render_fps(nlohmann::ordered_json& result) {
  try {
    result["render_frames_per_s"] = bench_render_fps();
  } catch (const FatalError& error) {
    if (error.code() != kExitNoDevice) throw;
    fmt::print(stderr, "bench: no render_frames_per_s: {}\n", error.what());
  }
}

nlohmann::ordered_json measure(const BenchOptions& options) {
  const Configuration standard;
  const Configuration thesis = thesis_configuration();
  nlohmann::ordered_json result;
  // With few frames, and first: what this process holds itself counts with its child's memory.
  const double rss_mb = bench_resident_mb(load_frames(options, kFewFrames), standard);
  const std::vector<cv::Mat> frames = load_frames(options, kMostFrames);
  const TickBench tick = bench_tick(frames, thesis, standard);
  const FlowBench flow = bench_flow(frames, thesis.flow, thesis.flow_history, standard.flow, standard.flow_history);
  const SegmentBench segment = bench_segment(frames);
  const DstarBench dstar = bench_dstar();
  const TemplateBench templates = bench_templates(frames);
  const double road_ms = bench_road_ms(frames);
  result["tick_over_opencv_flow"] = {{"thesis", tick.tick_thesis_ms / tick.opencv_thesis_ms},
                                     {"default", tick.tick_default_ms / tick.opencv_default_ms}};
  result["flow_over_opencv_flow"] = {{"thesis", flow.thesis_ms / flow.opencv_ms},
                                     {"default", flow.default_ms / flow.opencv_ms}};
  result["segment_over_memcpy"] = segment.steady_over_memcpy();
  result["segment_after_change_over_memcpy"] = segment.changed_over_memcpy();
  result["segment_speedup_over_cv_em"] = segment.speedup_over_em();
  result["templates_over_opencv"] = templates.over_opencv();
  result["templates_largest_difference"] = templates.largest_difference;
  result["road_frames_per_s"] = 1e3 / road_ms;
  result["dstar_speedup_weighted"] = dstar.dstar_speedup_weighted;
  result["dstar_speedup_uniform"] = dstar.dstar_speedup_uniform;
  result["dstar_worst_over_scratch"] = dstar.dstar_worst_over_scratch;
  result["motion_step_fps"] = bench_motion_fps();
  add_render_fps(result);
  result["allocations_per_tick"] = tick.allocations_per_tick;
  result["rss_mb"] = rss_mb;
  result["replay_over_realtime"] = bench_replay_over_realtime(frames, standard);
  result["ms"] = {{"opencv_flow_thesis", tick.opencv_thesis_ms}, {"opencv_flow_default", tick.opencv_default_ms},
                  {"tick_thesis", tick.tick_thesis_ms},
                  {"tick_default", tick.tick_default_ms},     {"flow_thesis", flow.thesis_ms},
                  {"flow_default", flow.default_ms},          {"memcpy_frame", segment.memcpy_ms},
                  {"segment", segment.segment_steady_ms},     {"segment_after_change", segment.segment_changed_ms},
                  {"cv_em_predict", segment.em_predict_ms},
                  {"opencv_templates", templates.opencv_ms}, {"templates", templates.ours_ms}, {"road", road_ms},
                    {"dstar_repair", dstar.repair_weighted_us * 1e-3},
                  {"bucket_astar", dstar.astar_weighted_us * 1e-3}};
  return result;
}

int bench(const BenchOptions& options) {
  const nlohmann::ordered_json result = measure(options);
  if (options.json) {
    fmt::print("{}\n", result.dump(2));
    return kExitOk;
  }
  const nlohmann::ordered_json flat = result.flatten();
  for (const auto& [key, value] : flat.items()) fmt::print("{:<40} {:>10.4g}\n", key.substr(1), value.get<double>());
  return kExitOk;
}

}  // namespace

void add_bench(CLI::App& app, Run& run) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App* command = app.add_subcommand("bench", "Time each stage and the whole tick, as ratios in one run, at 720 x 480");
  command->add_option("--frames", options->frames, "Folder of pictures to run on, scaled to 720 x 480; default: made ones");
  command->add_flag("--json", options->json, "Print JSON");
  add_bench_reflex(*command, run);
  command->callback([command, options, &run] {
    if (command->get_subcommands().empty()) run = [options] { return bench(*options); };
  });
}

}  // namespace hindsight::tools
