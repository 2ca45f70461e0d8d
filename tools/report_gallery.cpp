// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/report_gallery.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "tools/html_text.h"
#include "tools/report_frame.h"
#include "tools/report_lesson.h"
#include "tools/report_style.h"

namespace hindsight::tools {
namespace {

constexpr int kSpreadFrames = 16;
constexpr int kMostContactFrames = 12;
constexpr int kMostContactLessons = 12;
constexpr int kDrivenLessons = 4;

/// How far into the log picture number `number` of `count` evenly spread ones is due.
double due(int number, int count) { return (number + 0.5) / count; }

std::string figure(const std::string& file, const std::string& caption) {
  return fmt::format(
      "<figure><a href='{0}'><img src='{0}' loading='lazy' "
      "alt=''></a><figcaption>{1}</figcaption></figure>\n",
      file, escape_html(caption));
}

bool any_contact(std::span<const Lesson> lessons) {
  return std::any_of(lessons.begin(), lessons.end(),
                     [](const Lesson& lesson) { return is_contact(lesson.event.cause); });
}

std::string frame_caption(ReplayRun& run, double time_s) {
  std::string caption = fmt::format("tick {}, {:.1f} s: {}, stop reason {}", run.input().index, time_s,
                                    name_of(run.robot().plan().behaviour), name_of(run.decision().reason));
  for (const Lesson& lesson : run.robot().learner().lessons()) {
    if (is_contact(lesson.event.cause)) caption += fmt::format("; {}", name_of(lesson.event.cause));
  }
  return caption;
}

std::string lesson_caption(const Lesson& lesson, std::uint64_t tick, double time_s) {
  const TrainingEvent& event = lesson.event;
  return fmt::format(
      "tick {}, {:.1f} s: {}, taught {}. Left: {} frames ago, {:.0f} x {:.0f} px. Right: traced to {} frames "
      "ago, "
      "{:.0f} x {:.0f} px; {} points gave {} pixels, {} left out, {} new components.",
      tick, time_s, name_of(event.cause), name_of(event.label), event.frames_back, event.patch_px.width_px,
      event.patch_px.height_px, lesson.traced.frames_back, lesson.traced.there_px.width_px,
      lesson.traced.there_px.height_px, lesson.traced.points, lesson.traced.pixels, lesson.report.left_out,
      lesson.report.new_components);
}

}  // namespace

void Gallery::look(ReplayRun& run, double time_s) {
  look_at_frame(run, time_s);
  for (const Lesson& lesson : run.robot().learner().lessons()) look_at_lesson(run, lesson, time_s);
}

void Gallery::look_at_frame(ReplayRun& run, double time_s) {
  const FrameRef& frame = run.input().frame;
  const CameraModel& camera = run.camera();
  if (!frame || frame->width_px != camera.width_px || frame->height_px != camera.height_px) return;
  const auto lessons = run.robot().learner().lessons();
  const bool spread =
      spread_frames_ < kSpreadFrames && run.source().progress() >= due(spread_frames_, kSpreadFrames);
  const bool contact = contact_frames_ < kMostContactFrames && any_contact(lessons);
  if (!spread && !contact) return;
  if (spread) ++spread_frames_;
  if (contact) ++contact_frames_;
  const std::string file = fmt::format("frame_{:06}.jpg", run.input().index);
  folder_.write_picture(file, draw_frame(*frame, run.robot(), touched_patches(lessons)));
  frames_html_ += figure(file, frame_caption(run, time_s));
}

bool Gallery::wants(const Lesson& lesson, double progress) {
  if (is_contact(lesson.event.cause)) return contact_lessons_ < kMostContactLessons;
  return driven_lessons_ < kDrivenLessons && progress >= due(driven_lessons_, kDrivenLessons);
}

void Gallery::look_at_lesson(ReplayRun& run, const Lesson& lesson, double time_s) {
  if (!wants(lesson, run.source().progress())) return;
  const cv::Mat pair = draw_lesson(lesson, run.robot().sight().appearance());
  if (pair.empty()) return;
  ++(is_contact(lesson.event.cause) ? contact_lessons_ : driven_lessons_);
  const std::string file = fmt::format("lesson_{:02}.png", lessons_++);
  folder_.write_picture(file, pair);
  lessons_html_ += figure(file, lesson_caption(lesson, run.input().index, time_s));
}

}  // namespace hindsight::tools
