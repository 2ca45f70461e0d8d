// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

#include "daemon/heartbeats.h"

namespace hindsight {

enum class ThreadVerdict {
  well,
  died,  ///< a thread ended by an exception; all can still be joined
  hung   ///< a thread is silent and may never end
};

/// Judges the heartbeats, every now and then. A thread is taken to hang only if it is silent in two looks in
/// a row: when the whole process was stopped for a while (a debugger, SIGSTOP), all are late in the first.
class ThreadJudge {
 public:
  ThreadJudge(const Heartbeats& heartbeats, Time limit) : heartbeats_(heartbeats), limit_(limit) {}

  ThreadVerdict look(Time now) {
    culprit_ = heartbeats_.dead();
    if (!culprit_.empty()) return ThreadVerdict::died;
    const std::string_view late = heartbeats_.late(now, limit_);
    const bool again = !late.empty() && late == late_before_;
    late_before_ = late;
    if (!again) return ThreadVerdict::well;
    culprit_ = late;
    return ThreadVerdict::hung;
  }
  /// Whom the last verdict is about; empty if all are well.
  std::string_view culprit() const { return culprit_; }

 private:
  const Heartbeats& heartbeats_;
  Time limit_;
  std::string_view culprit_;
  std::string_view late_before_;
};

}  // namespace hindsight
