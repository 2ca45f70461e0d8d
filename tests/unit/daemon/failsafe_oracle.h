// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The table of daemon/failsafe.h told a second time, as a question to the whole history instead of a state:
// "is there an arm that nothing has ended since?" It shares no line with the machine that it judges.
#pragma once

#include <algorithm>
#include <vector>

#include "daemon/failsafe.h"

namespace hindsight {

class FailsafeOracle {
 public:
  explicit FailsafeOracle(const FailsafeParams& params) : params_(params) {}

  /// What Failsafe::step() has to answer to `input`.
  StopReason answer(const FailsafeInput& input) {
    late_.push_back(input.overrun);
    const StopReason cause = cause_of(input);
    remember({Event::tick_begins, input.estop_active, cause});
    for (const OperatorCommand& command : input.commands) {
      remember({event_of(command.kind), input.estop_active, cause});
    }
    // What is over by now stops what is armed, and keeps nobody from arming again.
    const bool was_lost =
        input.reflex_reason == StopReason::gpio || input.reflex_reason == StopReason::can_bus;
    const bool over = cause == StopReason::none && was_lost;
    remember({Event::tick_ends, input.estop_active, over ? input.reflex_reason : cause});
    return history_.back().reason;
  }

 private:
  enum class Event { tick_begins, stop, disarm, release, arm, other, tick_ends };
  struct Moment {
    Event event;
    bool estop_line;
    StopReason cause;  ///< of what is required, the e-stop aside
    StopReason reason = StopReason::not_armed;
    bool started = false;  ///< armed by itself
  };

  static Event event_of(CommandKind kind) {
    if (kind == CommandKind::stop) return Event::stop;
    if (kind == CommandKind::disarm) return Event::disarm;
    if (kind == CommandKind::release_estop) return Event::release;
    return kind == CommandKind::arm ? Event::arm : Event::other;
  }

  StopReason cause_of(const FailsafeInput& input) const {
    const auto lost = [&](Source source) {
      return input.sources[static_cast<std::size_t>(source)] != SourceState::fresh;
    };
    const auto in_time = std::find(late_.rbegin(), late_.rend(), false);
    const bool overruns = in_time - late_.rbegin() > params_.max_overruns;
    const std::pair<bool, StopReason> by_priority[] = {
        {lost(Source::gpio), StopReason::gpio},
        {lost(Source::can), StopReason::can_bus},
        {!input.wheels_fresh, StopReason::wheels},
        {lost(Source::camera), StopReason::camera},
        {input.gps_lost, StopReason::gps},
        {input.bumper_left_stuck, StopReason::bumper_left_stuck},
        {input.bumper_right_stuck, StopReason::bumper_right_stuck},
        {overruns, StopReason::overruns}};
    for (const auto& [holds, reason] : by_priority) {
      if (holds) return reason;
    }
    return StopReason::none;
  }

  bool estop_unreleased() const {
    for (auto moment = history_.rbegin(); moment != history_.rend(); ++moment) {
      if (moment->estop_line) return true;
      if (moment->event == Event::release) return false;
    }
    return false;
  }

  bool may_start() const {
    const auto ends_the_start = [](const Moment& m) {
      return m.estop_line || m.started || m.event == Event::stop || m.event == Event::disarm;
    };
    return params_.arm_at_start && std::none_of(history_.begin(), history_.end(), ends_the_start);
  }

  StopReason reason_before() const {
    return history_.empty() ? StopReason::not_armed : history_.back().reason;
  }

  void remember(Moment moment) {
    const bool held_before = estop_unreleased();
    const bool armed_before = reason_before() == StopReason::none;
    const bool held = moment.estop_line || (held_before && moment.event != Event::release);
    moment.started = moment.event == Event::tick_begins && !moment.estop_line && may_start() &&
                     moment.cause == StopReason::none;
    moment.reason = reason_before();
    if (held) {
      moment.reason = StopReason::estop;
    } else if (moment.event == Event::stop) {
      moment.reason = StopReason::operator_stop;
    } else if ((moment.event == Event::disarm && armed_before) || held_before) {
      moment.reason = StopReason::not_armed;
    } else if (moment.event == Event::arm || (moment.event == Event::tick_ends && armed_before)) {
      moment.reason = moment.cause;
    } else if (moment.started) {
      moment.reason = StopReason::none;
    }
    history_.push_back(moment);
  }

  FailsafeParams params_;
  std::vector<bool> late_;
  std::vector<Moment> history_;
};

}  // namespace hindsight
