// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Faults put into a stream of samples, so that an operator can rehearse them on a recorded run.
//
// clang-format off
//   word          camera                        can                     gpio                  gps
//   ------------  ----------------------------  ----------------------  --------------------  -------------------
//   off           no pictures                   no frames               the chip has failed   no fixes
//   stuck         the last picture, for ever    each message's last     no edges              the last place
//   garbage       damaged: dropped and counted  data at random          edges at random       places at random
//   wrong         upside down                   a neighbour's data      levels inverted       100 m to the north
//   slow          of all samples, every fifth
//   delayed       all samples half a second late, stamps and all as if they had come then
//   intermittent  off and on for half a second each
// clang-format on
//
// When a fault of the lines ends, the edges that it hid or made up are set right, as the driver does that reads
// the lines again.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "drivers/frame_pool.h"
#include "drivers/tick_input.h"

namespace hindsight {

enum class FaultKind : std::uint8_t { off, stuck, garbage, wrong, slow, delayed, intermittent };
inline constexpr std::array kFaultWords{"off",  "stuck",   "garbage",     "wrong",
                                        "slow", "delayed", "intermittent"};

struct FaultSpec {
  Source source = Source::camera;  ///< camera, can, gpio or gps
  FaultKind kind = FaultKind::off;
  Time begin{};   ///< since the first tick
  Time length{};  ///< how long it lasts
};

/// "SOURCE:WORD:BEGINs:LENGTHs", such as "camera:stuck:12.5s:2s". FatalError(kExitUsage) that says what is
/// wrong with it and what is known.
FaultSpec parse_fault(const std::string& text);

/// Changes ticks before the robot sees them; must outlive them, since pictures that it made are its own. The
/// same faults and ticks give the same changes. Allocates. One thread.
class SampleFaults {
 public:
  explicit SampleFaults(std::vector<FaultSpec> faults);

  /// Call for each tick of a run, in order.
  void inject(TickInput& input);

 private:
  template <typename Sample>
  struct Channel {
    std::deque<Sample> late;  ///< held back, oldest first
    std::uint32_t seen = 0;   ///< samples, for "slow"
  };

  template <typename Sample>
  void thin(const FaultSpec& fault, Time now, Channel<Sample>& channel, std::vector<Sample>& samples);
  void inject_camera(const FaultSpec& fault, TickInput& input);
  void inject_can(const FaultSpec& fault, TickInput& input);
  void inject_gpio(const FaultSpec& fault, TickInput& input);
  void inject_gps(const FaultSpec& fault, TickInput& input);
  /// Says that the GPIO chip has failed or is back, once each.
  void report_chip(TickInput& input);
  void set_lines_right(TickInput& input);
  bool any_lasts_of_lines(Time now, std::optional<FaultKind> kind) const;
  FrameRef copy_of(const Frame& frame);
  void remember(const TickInput& input);
  std::uint64_t random();
  bool lasts(const FaultSpec& fault, Time now) const;

  std::vector<FaultSpec> faults_;
  std::optional<Time> began_;
  std::uint64_t random_state_ = 1;
  FramePool pool_;
  std::vector<FrameRef> frames_;  ///< of this tick, at most one
  Channel<FrameRef> camera_;
  Channel<CanFrame> can_;
  Channel<LineEdge> gpio_;
  Channel<GpsFix> gps_;
  FrameRef last_frame_;
  std::map<std::uint32_t, CanFrame> last_can_;  ///< by identifier
  std::optional<GpsFix> last_fix_;
  std::array<bool, kLineCount> levels_{}, told_levels_{};  ///< the lines' own, and as passed on
  bool chip_failed_ = false;
  std::uint32_t dropped_ = 0;  ///< damaged pictures
};

}  // namespace hindsight
