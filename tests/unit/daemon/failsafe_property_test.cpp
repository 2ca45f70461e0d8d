// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Random stories, told to fail-safe, board and gate as the program wires them: lines that bounce, sources
// that come and go, a loop that hangs, operators who ask for anything. Two judges who know only the
// documentation: FailsafeOracle for the loop's reason, `forbidden` for the gate's.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "daemon/reflex.h"
#include "failsafe_oracle.h"

namespace hindsight {
namespace {

#if defined(HINDSIGHT_SANITIZED) || defined(HINDSIGHT_FEW_STORIES)
constexpr int kStories = 30'000;
#else
constexpr int kStories = 1'000'000;
#endif
constexpr std::uint32_t kSeed = 20261128;
constexpr Time kTick = from_seconds(0.1);
constexpr Time kReflexPeriod =
    from_seconds(0.025);  // coarser than the program's, to have time for more stories

using Random = std::mt19937;
bool one_in(Random& random, Random::result_type n) { return random() % n == 0; }

/// How often a kind of stop has been seen, so that the test can say that the stories reached it.
struct Tally {
  std::array<std::uint64_t, kStopReasonCount> loop{};
  std::array<std::uint64_t, kStopReasonCount> gate{};
  std::uint64_t moved = 0;
};

class Story {
 public:
  Story(Random& random, Tally& tally)
      : random_(random),
        tally_(tally),
        trouble_(2U + random() % 30U),
        params_{.max_overruns = 1 + static_cast<int>(random() % 3), .arm_at_start = one_in(random, 2)},
        failsafe_(params_),
        oracle_(params_),
        reflex_(GateParams{}, vehicle_) {
    sources_.fill(SourceState::fresh);
    board_.last_look_at_lines_ns = looked_.count();
  }

  void tell() {
    for (auto ticks = 4 + random_() % 8; ticks > 0 && !testing::Test::HasFatalFailure(); --ticks) {
      const bool hangs = one_in(random_, 4 * trouble_);
      live_until(now_ + kTick * (hangs ? 4 : 1));
      think();
    }
  }

 private:
  // -- Between ticks: lines and drivers change what the board says, the reflex runs.
  void live_until(Time end) {
    while (now_ < end && !testing::Test::HasFatalFailure()) {
      now_ += Time(static_cast<Time::rep>(random_()) % kReflexPeriod.count() + 1);
      if (one_in(random_, trouble_)) change_line();
      if (one_in(random_, trouble_)) change_source();
      board_.lines_ok = source(Source::gpio) == SourceState::fresh;
      board_.bus_ok = source(Source::can) == SourceState::fresh;
      if (!nobody_looks_) board_.last_look_at_lines_ns = (looked_ = now_).count();
      board_.bus_takes_frames = !bus_is_full_;
      board_.thread_lost = thread_lost_;
      reflex();
    }
  }

  void change_line() {
    const auto line = static_cast<Line>(random_() % kLineCount);
    bool& active = active_[static_cast<std::size_t>(line)];
    active = !active;
    board_.see({now_, line, active});
    if (!active) return;
    touched_[static_cast<std::size_t>(line)] = true;
    pressed_at_[line == Line::estop] = now_;
    if (one_in(random_, 2)) return;
    active = false;  // over before the reflex has looked
    board_.see({now_, line, active});
  }

  SourceState& source(Source which) { return sources_[static_cast<std::size_t>(which)]; }
  void change_source() {
    const std::array<bool*, 8> troubles{&wheels_fresh_,    &wheels_fresh_, &gps_lost_,    &bumper_stuck_[0],
                                        &bumper_stuck_[1], &nobody_looks_, &bus_is_full_, &thread_lost_};
    if (one_in(random_, 3)) {
      bool& trouble = *troubles[random_() % troubles.size()];
      trouble = !trouble;
      return;
    }
    SourceState& state = sources_[random_() % kSourceCount];
    state = state == SourceState::fresh ? static_cast<SourceState>(random_() % 5) : SourceState::fresh;
  }

  void reflex() {
    const GateOutput output = reflex_.step(now_, board_);
    const DriveCommand& out = output.command;
    ++tally_.gate[static_cast<std::size_t>(output.reason)];
    tally_.moved += out != DriveCommand{};
    ASSERT_EQ(output.reason, forbidden());
    ASSERT_TRUE(output.reason == StopReason::none || out == DriveCommand{});
    const bool pressed = active_[0] || active_[1];
    ASSERT_FALSE(pressed && (out.left_mps > 0.0 || out.right_mps > 0.0));
    ASSERT_LE(std::max(std::abs(out.left_mps), std::abs(out.right_mps)), vehicle_.max_speed_mps);
  }

  /// What of all that is true in this world forbids motion first, by the order that ARCHITECTURE.md gives.
  StopReason forbidden() const {
    const DriveCommand& wanted = decision_.command;
    const bool forward = wanted.left_mps > 0.0 || wanted.right_mps > 0.0;
    const auto fresh = [&](Source which) {
      return sources_[static_cast<std::size_t>(which)] == SourceState::fresh;
    };
    const std::pair<bool, StopReason> by_priority[] = {
        {active_[static_cast<std::size_t>(Line::estop)] || pressed_at_[1] > decision_.decided_at,
         StopReason::estop},
        {thread_lost_, StopReason::thread},
        {decision_.reason != StopReason::none, decision_.reason},
        {!fresh(Source::gpio) || now_ - looked_ > from_seconds(0.25), StopReason::gpio},
        {!fresh(Source::can) || bus_is_full_, StopReason::can_bus},
        {now_ - decision_.decided_at > from_seconds(0.25), StopReason::stale_command},
        {!std::isfinite(wanted.left_mps) || !std::isfinite(wanted.right_mps), StopReason::bad_command},
        {pressed_at_[0] > decision_.decided_at, StopReason::bumper},
        {(active_[0] || active_[1]) && forward, StopReason::bumper}};
    for (const auto& [holds, reason] : by_priority) {
      if (holds) return reason;
    }
    return StopReason::none;
  }

  // -- A tick of the loop: fail-safe, then a plan that need not be sane.
  void think() {
    const std::vector<OperatorCommand> commands = some_commands();
    const FailsafeInput input{.sources = sources_,
                              .wheels_fresh = wheels_fresh_,
                              .estop_active = touched_[static_cast<std::size_t>(Line::estop)],
                              .gps_lost = gps_lost_,
                              .bumper_left_stuck = bumper_stuck_[0],
                              .bumper_right_stuck = bumper_stuck_[1],
                              .reflex_reason = some_reflex_reason(),
                              .overrun = one_in(random_, 3),
                              .commands = commands};
    const StopReason before = reason_;
    reason_ = failsafe_.step(input);
    ++tally_.loop[static_cast<std::size_t>(reason_)];
    ASSERT_EQ(reason_, oracle_.answer(input));
    ASSERT_EQ(failsafe_.armed(), reason_ == StopReason::none);
    if (reason_ == StopReason::none && before != StopReason::none) expect_way_out(commands);
    const bool watching = reason_ == StopReason::none && one_in(random_, trouble_);
    decision_ = {some_command(), now_, watching ? StopReason::watching : reason_};
    board_.decision.write(decision_);
    touched_ = active_;
  }

  /// A latched stop ends by an operator's arm alone; the one way round it is the start, once.
  void expect_way_out(const std::vector<OperatorCommand>& commands) {
    const auto is_arm = [](const OperatorCommand& command) { return command.kind == CommandKind::arm; };
    if (std::any_of(commands.begin(), commands.end(), is_arm)) return;
    ASSERT_TRUE(params_.arm_at_start && !std::exchange(started_, true));
  }

  std::vector<OperatorCommand> some_commands() {
    constexpr std::array kinds = {CommandKind::arm,   CommandKind::arm,           CommandKind::arm,
                                  CommandKind::stop,  CommandKind::release_estop, CommandKind::release_estop,
                                  CommandKind::disarm};
    std::vector<OperatorCommand> commands(one_in(random_, 2) ? random_() % 4 : 0);
    for (OperatorCommand& command : commands) {
      command.kind =
          one_in(random_, 6) ? static_cast<CommandKind>(random_() % 9) : kinds[random_() % kinds.size()];
    }
    return commands;
  }

  StopReason some_reflex_reason() {
    if (!one_in(random_, trouble_)) return StopReason::none;
    return static_cast<StopReason>(random_() % kStopReasonCount);
  }

  double some_speed_mps() {
    constexpr double kOdd[] = {std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity(), 0.0};
    if (one_in(random_, 4 * trouble_)) return kOdd[random_() % 4];
    return 4.0 * static_cast<double>(random_()) / static_cast<double>(Random::max()) - 2.0;
  }
  DriveCommand some_command() { return {some_speed_mps(), some_speed_mps()}; }

  Random& random_;
  Tally& tally_;
  Random::result_type trouble_;  ///< one in so many chances is taken
  FailsafeParams params_;
  VehicleParams vehicle_;
  Failsafe failsafe_;
  FailsafeOracle oracle_;
  Reflex reflex_;
  ReflexBoard board_;

  Time now_ = from_seconds(1.0);
  std::array<SourceState, kSourceCount> sources_{};
  bool wheels_fresh_ = true, gps_lost_ = false, nobody_looks_ = false, bus_is_full_ = false,
       thread_lost_ = false;
  std::array<bool, 2> bumper_stuck_{};
  Time looked_ = now_;  ///< at the lines
  std::array<bool, kLineCount> active_{};
  std::array<bool, kLineCount> touched_{};  ///< since the last tick
  std::array<Time, 2> pressed_at_{};        ///< a bumper, the e-stop
  Decision decision_;
  StopReason reason_ = StopReason::not_armed;
  bool started_ = false;
};

TEST(FailsafeProperty, NoStoryMovesAVehicleThatMustStand) {
  Random random(kSeed);
  Tally tally;
  for (int story = 0; story < kStories && !HasFatalFailure(); ++story) {
    Story(random, tally).tell();
    if (HasFatalFailure()) FAIL() << "in story " << story << " of seed " << kSeed;
  }
  EXPECT_GT(tally.moved, static_cast<std::uint64_t>(kStories))
      << "stories in which nothing drives show nothing";
  for (const StopReason reason :
       {StopReason::not_armed, StopReason::operator_stop, StopReason::estop, StopReason::camera,
        StopReason::can_bus, StopReason::wheels, StopReason::gpio, StopReason::overruns, StopReason::gps,
        StopReason::bumper_left_stuck, StopReason::bumper_right_stuck}) {
    EXPECT_GT(tally.loop[static_cast<std::size_t>(reason)], kStories / 100U) << name_of(reason);
  }
  for (const StopReason reason : {StopReason::stale_command, StopReason::bumper, StopReason::bad_command,
                                  StopReason::watching, StopReason::thread}) {
    EXPECT_GT(tally.gate[static_cast<std::size_t>(reason)], kStories / 100U) << name_of(reason);
  }
}

}  // namespace
}  // namespace hindsight
