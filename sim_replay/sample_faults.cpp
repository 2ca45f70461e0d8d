// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/sample_faults.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <utility>

#include "config/exit_code.h"

namespace hindsight {
namespace {

constexpr std::array kSourceWords{"camera", "can", "gpio", "gps"};
constexpr Time kHalfSecond = std::chrono::milliseconds(500);
constexpr std::uint32_t kSlowEvery = 5;
constexpr std::size_t kPictures = 64;            // half a second's at 100 a second, and those at hand
constexpr double kJump_deg = 100.0 / 111'195.0;  // 100 m of latitude

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  throw FatalError(kExitUsage, fmt::format("--inject {}: {}; expected SOURCE:WORD:BEGINs:LENGTHs, such as "
                                           "camera:stuck:12.5s:2s",
                                           text, why));
}

template <std::size_t count>
std::size_t index_of(const std::array<const char*, count>& words, const std::string& word,
                     const std::string& text) {
  const auto found = std::ranges::find(words, word);
  if (found == words.end()) refuse(text, fmt::format("'{}' is none of {}", word, fmt::join(words, ", ")));
  return static_cast<std::size_t>(found - words.begin());
}

Time parse_time(std::string word, const std::string& text) {
  if (word.ends_with('s')) word.pop_back();
  double seconds = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), seconds);
  constexpr double kDay_s = 86400.0;
  if (error != std::errc{} || end != word.data() + word.size() || !(seconds >= 0.0) || seconds > kDay_s)
    refuse(text, fmt::format("'{}' is no time in seconds", word));
  return from_seconds(seconds);
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ':')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

Time stamp_of(const FrameRef& frame) { return frame->stamp; }
template <typename Sample>
Time stamp_of(const Sample& sample) {
  return sample.stamp;
}

void set_stamp(FrameRef& frame, Time stamp) { frame.writable().stamp = stamp; }
template <typename Sample>
void set_stamp(Sample& sample, Time stamp) {
  sample.stamp = stamp;
}

void turn_upside_down(Frame& frame) {
  const auto pixels = frame.bgr.size() / 3;
  for (std::size_t i = 0, j = pixels; i + 1 < j--; ++i)
    std::swap_ranges(&frame.bgr[3 * i], &frame.bgr[3 * i] + 3, &frame.bgr[3 * j]);
}

}  // namespace

FaultSpec parse_fault(const std::string& text) {
  const std::vector<std::string> parts = split(text);
  if (parts.size() != 4) refuse(text, fmt::format("it has {} parts, not four", parts.size()));
  FaultSpec fault;
  fault.source = static_cast<Source>(index_of(kSourceWords, parts[0], text));
  fault.kind = static_cast<FaultKind>(index_of(kFaultWords, parts[1], text));
  fault.begin = parse_time(parts[2], text);
  fault.length = parse_time(parts[3], text);
  return fault;
}

SampleFaults::SampleFaults(std::vector<FaultSpec> faults)
    : faults_(std::move(faults)), pool_(kPictures, 0, 0) {}

void SampleFaults::inject(TickInput& input) {
  if (!began_) began_ = input.now;
  remember(input);
  for (const FaultSpec& fault : faults_) {
    if (fault.source == Source::camera) inject_camera(fault, input);
    if (fault.source == Source::can) inject_can(fault, input);
    if (fault.source == Source::gpio) inject_gpio(fault, input);
    if (fault.source == Source::gps) inject_gps(fault, input);
  }
  report_chip(input);
  set_lines_right(input);
}

bool SampleFaults::lasts(const FaultSpec& fault, Time now) const {
  const Time since = now - *began_ - fault.begin;
  return since >= Time{} && since < fault.length;
}

/// What each source said last, before any fault touches it.
void SampleFaults::remember(const TickInput& input) {
  const auto stuck = [&](Source source) {
    return std::ranges::any_of(faults_, [&](const FaultSpec& fault) {
      return fault.source == source && fault.kind == FaultKind::stuck && lasts(fault, input.now);
    });
  };
  if (input.frame && !stuck(Source::camera)) last_frame_ = copy_of(*input.frame);
  if (!stuck(Source::can)) {
    for (const CanFrame& frame : input.can) last_can_[frame.id] = frame;
  }
  if (!input.fixes.empty() && !stuck(Source::gps)) last_fix_ = input.fixes.back();
  for (const LineEdge& edge : input.edges) levels_[static_cast<std::size_t>(edge.line)] = edge.active;
}

/// off, slow, delayed, intermittent: the same for samples of every kind.
template <typename Sample>
void SampleFaults::thin(const FaultSpec& fault, Time now, Channel<Sample>& channel,
                        std::vector<Sample>& samples) {
  const bool on = lasts(fault, now);
  if (on && fault.kind == FaultKind::off) samples.clear();
  if (on && fault.kind == FaultKind::slow)
    std::erase_if(samples, [&](const Sample&) { return channel.seen++ % kSlowEvery != 0; });
  if (on && fault.kind == FaultKind::intermittent && (now - *began_ - fault.begin) / kHalfSecond % 2 == 0)
    samples.clear();
  if (fault.kind != FaultKind::delayed) return;
  // What was held back when the fault ends still comes, each when its time has come.
  if (on) channel.late.insert(channel.late.end(), samples.begin(), samples.end()), samples.clear();
  while (!channel.late.empty() && stamp_of(channel.late.front()) + kHalfSecond <= now) {
    samples.push_back(channel.late.front());
    set_stamp(samples.back(), stamp_of(samples.back()) + kHalfSecond);
    channel.late.pop_front();
  }
}

FrameRef SampleFaults::copy_of(const Frame& frame) {
  FrameRef copy = pool_.take();
  if (copy) copy.writable() = frame;
  return copy;
}

void SampleFaults::inject_camera(const FaultSpec& fault, TickInput& input) {
  frames_.clear();
  if (input.frame) frames_.push_back(fault.kind == FaultKind::delayed ? copy_of(*input.frame) : input.frame);
  thin(fault, input.now, camera_, frames_);
  input.frame = frames_.empty() ? FrameRef() : frames_.back();
  if (!lasts(fault, input.now) || !input.frame) return;
  if (fault.kind == FaultKind::garbage) {
    input.frame = {};
    input.reports.push_back({input.now, Source::camera, SourceState::fresh, ++dropped_, EBADMSG});
  }
  if (fault.kind == FaultKind::stuck && last_frame_) {
    FrameRef again = copy_of(*last_frame_);
    again.writable().stamp = input.frame->stamp;
    again.writable().sequence = input.frame->sequence;
    input.frame = again;
  }
  if (fault.kind == FaultKind::wrong) {
    input.frame = copy_of(*input.frame);
    turn_upside_down(input.frame.writable());
  }
}

void SampleFaults::inject_can(const FaultSpec& fault, TickInput& input) {
  thin(fault, input.now, can_, input.can);
  if (!lasts(fault, input.now)) return;
  for (std::size_t i = 0; i < input.can.size(); ++i) {
    CanFrame& frame = input.can[i];
    if (fault.kind == FaultKind::stuck && last_can_.contains(frame.id)) frame.data = last_can_[frame.id].data;
    if (fault.kind == FaultKind::garbage) {
      for (std::uint8_t& byte : frame.data) byte = static_cast<std::uint8_t>(random());
    }
    if (fault.kind == FaultKind::wrong && i > 0 && frame.id != input.can[i - 1].id)
      std::swap(frame.data, input.can[i - 1].data);
  }
}

void SampleFaults::inject_gpio(const FaultSpec& fault, TickInput& input) {
  thin(fault, input.now, gpio_, input.edges);
  if (!lasts(fault, input.now)) return;
  if (fault.kind == FaultKind::stuck) input.edges.clear();
  if (fault.kind == FaultKind::garbage)
    input.edges.push_back({input.now, static_cast<Line>(random() % kLineCount), random() % 2 == 0});
  if (fault.kind == FaultKind::wrong) {
    for (LineEdge& edge : input.edges) edge.active = !edge.active;
  }
}

bool SampleFaults::any_lasts_of_lines(Time now, std::optional<FaultKind> kind) const {
  return std::ranges::any_of(faults_, [&](const FaultSpec& fault) {
    return fault.source == Source::gpio && (!kind || fault.kind == *kind) && lasts(fault, now);
  });
}

void SampleFaults::report_chip(TickInput& input) {
  const bool failed = any_lasts_of_lines(input.now, FaultKind::off);
  if (failed == chip_failed_) return;
  chip_failed_ = failed;
  input.reports.push_back(
      {input.now, Source::gpio, failed ? SourceState::failed : SourceState::fresh, 0, failed ? ENODEV : 0});
}

void SampleFaults::set_lines_right(TickInput& input) {
  for (const LineEdge& edge : input.edges) told_levels_[static_cast<std::size_t>(edge.line)] = edge.active;
  if (any_lasts_of_lines(input.now, std::nullopt) || !gpio_.late.empty()) return;
  for (std::size_t line = 0; line < kLineCount; ++line) {
    if (told_levels_[line] == levels_[line]) continue;
    told_levels_[line] = levels_[line];
    input.edges.push_back({input.now, static_cast<Line>(line), levels_[line]});
  }
}

void SampleFaults::inject_gps(const FaultSpec& fault, TickInput& input) {
  thin(fault, input.now, gps_, input.fixes);
  if (!lasts(fault, input.now)) return;
  for (GpsFix& fix : input.fixes) {
    if (fault.kind == FaultKind::stuck && last_fix_) {
      fix.latitude_deg = last_fix_->latitude_deg;
      fix.longitude_deg = last_fix_->longitude_deg;
    }
    if (fault.kind == FaultKind::garbage) {
      const auto scatter = [&] { return static_cast<double>(random() % 2001) / 1000.0 - 1.0; };
      fix.latitude_deg = std::clamp(fix.latitude_deg + scatter(), -90.0, 90.0);
      fix.longitude_deg += scatter();
    }
    if (fault.kind == FaultKind::wrong) fix.latitude_deg += kJump_deg;
  }
}

/// xorshift64 (Marsaglia 2003).
std::uint64_t SampleFaults::random() {
  random_state_ ^= random_state_ << 13U;
  random_state_ ^= random_state_ >> 7U;
  return random_state_ ^= random_state_ << 17U;
}

}  // namespace hindsight
