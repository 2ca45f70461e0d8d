// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/importer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>

#include "config/exit_code.h"
#include "sim_replay/calibration_text.h"
#include "sim_replay/picture_source.h"
#include "sim_replay/run_log_writer.h"
#include "sim_replay/track_samples.h"

namespace hindsight {
namespace {

constexpr Time kFirstStamp = std::chrono::seconds(1);

Time rounded(double seconds) { return Time{std::llround(seconds * 1e9)}; }

std::int64_t event_time_us(Time stamp) { return stamp.count() / 1000; }

/// Time of the first row. Reads the whole track, so that a mistake in it is told before anything is written.
double check_track(const std::filesystem::path& path) {
  TrackCsv track(path);
  TrackRow row;
  std::optional<double> first_s;
  while (track.next(row)) first_s = first_s.value_or(row.time_s);
  return first_s.value_or(0.0);
}

class Import {
 public:
  Import(const ImportOptions& options, TrackEncoder& encoder)
      : options_(options),
        calibration_(read_calibration_text(options.camera)),
        samples_(encoder),
        pictures_(open_pictures(options.frames)) {
    if (!options.track.empty()) {
      first_s_ = std::min(0.0, check_track(options.track));
      track_.emplace(options.track);
    }
    read_picture();
    if (!picture_waits_) {
      throw FatalError(kExitBadData, fmt::format("{}: a video without frames", options.frames.string()));
    }
    read_row();
    log_.emplace(options.output);
    log_->write_header(
        {event_time_us(kFirstStamp), false, options.build_id, "", encoder.dbc(), calibration_.text, {}});
  }

  ImportSummary run(const ImportProgress& progress) {
    while (picture_waits_ || row_waits_) {
      if (row_waits_ && (!picture_waits_ || stamp_of(row_.time_s) <= frame_.stamp)) {
        write_row();
        read_row();
      } else {
        write_picture();
        progress(summary_.frames, pictures_->count());
        read_picture();
      }
      if (!log_->ok()) fail_to_write();
    }
    if (!log_->close()) fail_to_write();
    summary_.duration_s = to_seconds(last_stamp_ - kFirstStamp);
    summary_.bytes = log_->bytes_written();
    return summary_;
  }

 private:
  Time stamp_of(double time_s) const { return kFirstStamp + rounded(time_s) - rounded(first_s_); }

  void read_picture() {
    picture_waits_ = pictures_->next(frame_);
    if (!picture_waits_) return;
    check_size();
    frame_.stamp = stamp_of(static_cast<double>(summary_.frames) / options_.rate_hz);
    frame_.sequence = static_cast<std::uint32_t>(summary_.frames);
  }

  void check_size() const {
    const bool first = summary_.frames == 0;
    if (frame_.width_px == calibration_.width_px && frame_.height_px == calibration_.height_px) return;
    throw FatalError(
        kExitBadData,
        fmt::format("{}: {} x {} pixels, but {} {} x {}", pictures_->name(), frame_.width_px,
                    frame_.height_px, first ? options_.camera.string() + " is for" : "those before it have",
                    calibration_.width_px, calibration_.height_px));
  }

  void write_picture() {
    log_->write_frame(frame_, event_time_us(frame_.stamp));
    last_stamp_ = frame_.stamp;
    ++summary_.frames;
  }

  void read_row() { row_waits_ = track_ && track_->next(row_); }

  void write_row() {
    last_stamp_ = stamp_of(row_.time_s);
    const TrackSamples& samples = samples_.convert(row_, last_stamp_);
    const std::int64_t utime_us = event_time_us(last_stamp_);
    if (!samples.can.empty()) log_->write_can(samples.can, utime_us);
    for (const LineEdge& edge : samples.edges) log_->write_edge(edge, utime_us);
    for (const GpsFix& fix : samples.fixes) log_->write_fix(fix, utime_us);
    for (const OperatorCommand& command : samples.commands) log_->write_command(command, utime_us);
    ++summary_.rows;
    summary_.can_frames += samples.can.size();
    summary_.edges += samples.edges.size();
    summary_.fixes += samples.fixes.size();
    summary_.commands += samples.commands.size();
  }

  [[noreturn]] void fail_to_write() const {
    throw FatalError(kExitIo, fmt::format("{}: cannot write the log: {}", options_.output.string(),
                                          std::strerror(log_->error_code())));
  }

  const ImportOptions& options_;
  CalibrationText calibration_;
  TrackSampler samples_;
  std::unique_ptr<PictureSource> pictures_;
  std::optional<TrackCsv> track_;
  std::optional<RunLogWriter> log_;
  ImportSummary summary_;
  Frame frame_;
  TrackRow row_;
  bool picture_waits_ = false;
  bool row_waits_ = false;
  double first_s_ = 0.0;  ///< of the recording: the time of the first sample
  Time last_stamp_{};
};

}  // namespace

ImportSummary import_recording(const ImportOptions& options, TrackEncoder& encoder,
                               const ImportProgress& progress) {
  Import import(options, encoder);
  try {
    return import.run(progress);
  } catch (const FatalError&) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(options.output, ignored))
      std::filesystem::remove(options.output, ignored);
    throw;
  }
}

}  // namespace hindsight
