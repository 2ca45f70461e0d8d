// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The pictures that have to be drawn while a run goes by.
#pragma once

#include <string>

#include "daemon/replay_run.h"
#include "tools/report_folder.h"

namespace hindsight::tools {

/// Chooses and writes pictures of frames and of training events, and holds the HTML that shows them.
class Gallery {
 public:
  /// `folder` must outlive the gallery.
  explicit Gallery(const ReportFolder& folder) : folder_(folder) {}

  /// Looks at the tick that `run` has just stepped through. FatalError 74 where a picture cannot be written.
  void look(ReplayRun& run, double time_s);

  const std::string& frames_html() const { return frames_html_; }
  const std::string& lessons_html() const { return lessons_html_; }

 private:
  void look_at_frame(ReplayRun& run, double time_s);
  void look_at_lesson(ReplayRun& run, const Lesson& lesson, double time_s);
  bool wants(const Lesson& lesson, double progress);

  const ReportFolder& folder_;
  std::string frames_html_;
  std::string lessons_html_;
  int spread_frames_ = 0;
  int contact_frames_ = 0;
  int contact_lessons_ = 0;
  int driven_lessons_ = 0;
  int lessons_ = 0;
};

}  // namespace hindsight::tools
