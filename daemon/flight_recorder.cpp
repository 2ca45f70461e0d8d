// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/flight_recorder.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <turbojpeg.h>

#include <algorithm>
#include <cstring>
#include <ctime>
#include <system_error>
#include <utility>
#include <vector>

#include "config/exit_code.h"
#include "daemon/say.h"
#include "daemon/unix_clock.h"
#include "sim_replay/run_log_writer.h"

namespace hindsight {
namespace {

namespace fs = std::filesystem;

constexpr Time kAftermath = from_seconds(1.0);
constexpr std::size_t kMegabyte = std::size_t{1} << 20;

bool is_ours(const fs::path& file) {
  return file.filename().string().starts_with("fault_") && file.extension() == ".lcm";
}

}  // namespace

/// A picture as JPEG, into memory that is kept.
class FlightRecorder::Compressor {
 public:
  explicit Compressor(int quality) : quality_(quality) {}
  ~Compressor() { tjDestroy(handle_); }
  Compressor(const Compressor&) = delete;
  Compressor& operator=(const Compressor&) = delete;

  bool compress(const Frame& from, std::vector<std::uint8_t>& to) {
    buffer_.resize(tjBufSize(from.width_px, from.height_px, TJSAMP_420));
    unsigned char* jpeg = buffer_.data();
    unsigned long size = buffer_.size();
    if (tjCompress2(handle_, from.bgr.data(), from.width_px, 0, from.height_px, TJPF_BGR, &jpeg, &size,
                    TJSAMP_420, quality_, TJFLAG_NOREALLOC) != 0) {
      return false;
    }
    to.assign(jpeg, jpeg + size);
    return true;
  }

 private:
  int quality_;
  tjhandle handle_ = tjInitCompress();
  std::vector<unsigned char> buffer_;
};

FlightRecorder::FlightRecorder(const FlightRecorderParams& params, RunHeader header)
    : params_(params),
      header_(std::move(header)),
      ring_(static_cast<std::size_t>(params.memory_mb) * kMegabyte),
      encoder_(block_),
      compressor_(std::make_unique<Compressor>(params.jpeg_quality)),
      pictures_(1, 0, 0) {
  std::error_code error;
  fs::create_directories(params_.folder, error);
  if (error) say(Severity::warning, "flight recorder: {}: {}", params_.folder, error.message());
}

FlightRecorder::~FlightRecorder() { look_after(Time::max()); }

void FlightRecorder::take(const TickRecord& record) {
  remember(record);
  const StopReason fault =
      trigger_.see(record.reason, static_cast<StopReason>(record.input.reflex.stop_reason));
  if (fault == StopReason::none || due_fault_ != StopReason::none) return;
  due_fault_ = fault;
  due_ = record.input.now + kAftermath;
}

void FlightRecorder::remember(const TickRecord& record) {
  input_ = record.input;
  if (input_.frame && input_.frame->format != PixelFormat::mjpeg) compress_picture();
  block_.clear();
  encoder_.write_tick(input_);
  for (const Outbox::Message& message : record.outbox.messages()) {
    encoder_.write_published(message.channel, message.utime_us, message.bytes);
  }
  input_.frame = {};
  ring_.push(record.input.index, record.input.now, block_.bytes());
  ring_.forget_before(record.input.now - from_seconds(params_.seconds));
}

void FlightRecorder::compress_picture() {
  FrameRef slot = pictures_.take();
  const Frame& raw = *input_.frame;
  Frame& small = slot.writable();
  small.stamp = raw.stamp;
  small.sequence = raw.sequence;
  small.format = PixelFormat::mjpeg;
  small.width_px = raw.width_px;
  small.height_px = raw.height_px;
  small.exposure_s = raw.exposure_s;
  small.gain = raw.gain;
  input_.frame = compressor_->compress(raw, small.bytes) ? std::move(slot) : FrameRef{};
}

void FlightRecorder::look_after(Time now) {
  if (due_fault_ != StopReason::none && now >= due_) write(std::exchange(due_fault_, StopReason::none));
  const StopReason requested = requested_.load();
  if (requested == StopReason::none) return;
  write(requested);
  requested_.store(StopReason::none);
}

void FlightRecorder::write(StopReason fault) {
  if (ring_.ticks().empty()) return;
  const fs::path file = new_file(fault);
  const fs::path unfinished = fs::path(file) += ".part";
  try {
    RunLogWriter log(unfinished);
    log.write_header(header_);
    if (const std::uint64_t first = ring_.ticks().front().index; first > 0)
      log.write_gap(0, first, header_.utime_us);
    for (const TickRing::Tick& tick : ring_.ticks()) log.write_whole(ring_.bytes_of(tick));
    // Without waiting for the disk: a slow one would make this thread late.
    if (!log.close(false))
      throw FatalError(kExitIo, unfinished.string() + ": " + std::strerror(log.error_code()));
    fs::rename(unfinished, file);
    remove_oldest();
    say(Severity::notice, "flight recorder: {} ticks before the fault are in {}", ring_.ticks().size(),
        file.string());
  } catch (const std::exception& error) {
    std::error_code ignored;
    fs::remove(unfinished, ignored);
    say(Severity::warning, "flight recorder: {}", error.what());
  }
}

fs::path FlightRecorder::new_file(StopReason fault) const {
  std::string name = name_of(fault);
  std::replace(name.begin(), name.end(), ' ', '_');
  const std::time_t now_s = unix_now_us() / 1'000'000;
  return fs::path(params_.folder) / fmt::format("fault_{:%Y%m%dT%H%M%SZ}_{}.lcm", fmt::gmtime(now_s), name);
}

void FlightRecorder::remove_oldest() const {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(params_.folder)) {
    if (is_ours(entry.path())) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());  // their names begin with their time
  const std::size_t most = static_cast<std::size_t>(params_.files);
  for (std::size_t i = 0; i + most < files.size(); ++i) fs::remove(files[i]);
}

}  // namespace hindsight
