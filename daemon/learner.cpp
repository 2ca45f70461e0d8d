// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/learner.h"

#include "config/exit_code.h"

namespace hindsight {
namespace {

constexpr std::size_t kMostLessonsATick = 16;

}  // namespace

Learner::Learner(const Configuration& configuration, const CameraModel& camera,
                 const MixtureSnapshot& mixture)
    : enabled_(configuration.robot.learning),
      mixture_(configuration.mixture),
      events_(configuration.training, camera, configuration.vehicle, configuration.flow_history.depth),
      tracer_(configuration.reverse_flow) {
  pixels_.reserve(tracer_.capacity());
  lessons_.reserve(kMostLessonsATick);
  if (mixture.components.empty()) return;
  if (const std::string problem = mixture_.restore(mixture); !problem.empty()) {
    throw FatalError(kExitConfiguration, "saved mixture: " + problem);
  }
  texture_.restore(mixture.texture);
}

void Learner::start(const Frame& frame) {
  if (!mixture_.started()) mixture_.start(frame.bgr, frame.width_px, frame.height_px);
}

MixtureSnapshot Learner::snapshot() const {
  MixtureSnapshot snapshot = mixture_.snapshot();
  snapshot.texture = texture_.votes();
  return snapshot;
}

std::span<const Lesson> Learner::learn(const TrainingInput& input, const Sight& sight) {
  lessons_.clear();
  for (const TrainingEvent& event : events_.update(input)) {
    if (lessons_.size() < lessons_.capacity()) lessons_.push_back(study(event, sight));
  }
  return lessons_;
}

Lesson Learner::study(const TrainingEvent& event, const Sight& sight) {
  Lesson lesson;
  lesson.event = event;
  if (!enabled_ || !event.in_view) return lesson;
  lesson.traced =
      tracer_.trace(sight.history(), sight.appearance(), event.patch_px, event.frames_back, pixels_);
  lesson.report = mixture_.train(pixels_.bgr, event.label);
  texture_.train(pixels_.texture, event.label);
  return lesson;
}

}  // namespace hindsight
