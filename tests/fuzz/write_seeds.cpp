// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// write_seeds FOLDER: the fuzzers' seeds (tests/fuzz/corpus), by the code that writes such files in the
// program. Texts are copies of what stands in config/.
#include <turbojpeg.h>

#include <filesystem>
#include <fstream>
#include <vector>

#include "daemon/command_codec.h"
#include "daemon/saved_state.h"
#include "drivers/dbc.h"
#include "drivers/frame_pool.h"
#include "drivers/vehicle_base_codec.h"
#include "perception/activity_codec.h"
#include "perception/mixture_codec.h"
#include "sim_replay/run_log_writer.h"

namespace hindsight {
namespace {

namespace fs = std::filesystem;
using Content = std::vector<std::uint8_t>;

void write(const fs::path& file, const Content& content) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(content.data()), static_cast<std::streamsize>(content.size()));
}

template <class Number>
void append(Content& content, Number number) {
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(&number);
  content.insert(content.end(), bytes, bytes + sizeof number);
}

std::vector<CanFrame> frames_of_all_groups() {
  VehicleBaseCodec base(read_dbc(HINDSIGHT_SOURCE_DIR "/config/lagr.dbc"), {});
  VehicleSignals signals;
  signals.left_mps = 0.5;
  std::vector<CanFrame> frames;
  for (int repeat = 0; repeat < 2; ++repeat) {
    for (int group = 0; group < kSignalGroupCount; ++group) {
      base.encode(static_cast<SignalGroup>(group), signals, from_seconds(1.0), frames);
    }
  }
  return frames;
}

Content can_seed() {
  Content content;
  for (const CanFrame& frame : frames_of_all_groups()) {
    append(content, std::uint8_t{0});
    append(content, std::uint32_t{1});
    append(content, frame.id);
    append(content, frame.length);
    append(content, frame.data);
  }
  return content;
}

Content jpeg_seed(int subsampling) {
  Content pixels(32 * 24 * 3);
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<std::uint8_t>(i * i / 97);
  const tjhandle handle = tjInitCompress();
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  tjCompress2(handle, pixels.data(), 32, 0, 24, TJPF_BGR, &bytes, &size, subsampling, 60, 0);
  const Content content(bytes, bytes + size);
  tjFree(bytes);
  tjDestroy(handle);
  return content;
}

Content commands_seed(const std::optional<CommandKey>& key) {
  Content content;
  for (int kind = 0; kind <= static_cast<int>(CommandKind::save_model); ++kind) {
    const Content packet = encode_command({Time{}, static_cast<CommandKind>(kind), 1.0, -2.0, 0},
                                          1'700'000'000'000'000 + kind, key);
    content.push_back(static_cast<std::uint8_t>(packet.size()));
    content.insert(content.end(), packet.begin(), packet.end());
  }
  return content;
}

MixtureSnapshot some_mixture() {
  MixtureSnapshot mixture;
  for (int i = 0; i < 3; ++i) {
    MixtureComponent component;
    component.mean = Eigen::Vector3d(40.0 * i, 90.0, 120.0);
    component.covariance = Eigen::Matrix3d::Identity() * (9.0 + i);
    component.weight_px = 100.0;
    mixture.components.push_back(component);
  }
  return mixture;
}

ActivityMap some_activity() {
  ActivityMap map({.cell = 1.0, .cells = 8, .max_speed = 1.5});
  map.add({0.5, 0.5}, {0.3, 0.1});
  map.add({2.5, -1.5}, {-0.3, 0.1});
  return map;
}

void fill(Frame& frame) {
  frame.stamp = from_seconds(1.0);
  frame.format = PixelFormat::mjpeg;
  frame.width_px = 32;
  frame.height_px = 24;
  frame.bytes = jpeg_seed(TJSAMP_420);
}

void write_log_of_ticks(const fs::path& file) {
  FramePool pool(2, 0, 0);
  RunLogWriter log(file);
  log.write_header(
      {1'700'000'000'000'000, true, "seed", "[robot]\n", "VERSION \"\"", "image_width: 32", {1, 2, 3}});
  for (std::uint64_t index = 0; index < 4; index += 1 + index) {
    TickInput tick;
    tick.index = index;
    tick.now = from_seconds(1.0 + 0.1 * static_cast<double>(index));
    if (index == 1) {
      tick.frame = pool.take();
      fill(tick.frame.writable());
    }
    tick.can = frames_of_all_groups();
    tick.edges.push_back({tick.now, Line::estop, true});
    tick.fixes.push_back({tick.now, 48.0, 11.0, 500.0, 2.0});
    tick.commands.push_back({tick.now, CommandKind::arm, 0.0, 0.0, 1});
    tick.reports.push_back({tick.now, Source::can, SourceState::failed, 1, 5});
    log.write_tick(tick);
    log.write_published("HINDSIGHT_STATE", 1, Content{1, 2, 3});
  }
  log.close();
}

void write_log_of_samples(const fs::path& file) {
  RunLogWriter log(file);
  Frame frame;
  fill(frame);
  log.write_frame(frame, 1);
  log.write_can(frames_of_all_groups(), 2);
  log.write_edge({from_seconds(1.2), Line::bumper_left, true}, 3);
  log.write_fix({from_seconds(1.3), 48.0, 11.0, 500.0, 2.0}, 4);
  log.write_command({from_seconds(1.4), CommandKind::stop, 0.0, 0.0, 2}, 5);
  log.close();
}

void write_all(const fs::path& folder) {
  write(folder / "can/groups", can_seed());
  write(folder / "jpeg/420", jpeg_seed(TJSAMP_420));
  write(folder / "jpeg/422", jpeg_seed(TJSAMP_422));
  write(folder / "jpeg/grey", jpeg_seed(TJSAMP_GRAY));
  write(folder / "command/plain", commands_seed(std::nullopt));
  write(folder / "command/signed", commands_seed(CommandKey{1, 2, 3}));
  write(folder / "mixture/three", encode_mixture(some_mixture()));
  write(folder / "state/three", encode_state({1, 0.01, {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.1}, {2.0, 0.5, 0.2}}}));
  write(folder / "activity/two", encode_activity(some_activity()));
  fs::create_directories(folder / "run_log");
  write_log_of_ticks(folder / "run_log/ticks");
  write_log_of_samples(folder / "run_log/samples");
}

}  // namespace
}  // namespace hindsight

int main(int argc, char** argv) {
  if (argc != 2) return 64;
  hindsight::write_all(argv[1]);
  return 0;
}
