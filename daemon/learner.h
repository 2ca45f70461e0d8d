// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// From touch to knowledge: a training event's patch is traced back to how it looked from afar, and the
// mixture of colours and the textures' histograms learn from the pixels there (thesis 5.1).
#pragma once

#include <span>
#include <vector>

#include "daemon/robot_config.h"
#include "daemon/sight.h"
#include "perception/terrain_mixture.h"
#include "perception/texture_model.h"
#include "perception/training_events.h"
#include "perception/training_patch.h"

namespace hindsight {

/// What one event taught.
struct Lesson {
  TrainingEvent event;
  TracedPatch traced;
  TerrainMixture::TrainingReport report;
};

class Learner {
 public:
  Learner(const Configuration& configuration, const CameraModel& camera, const MixtureSnapshot& mixture);

  /// Makes the mixture from the first frame where there is none yet.
  void start(const Frame& frame);
  /// The lessons of this tick, valid until the next call. Learns nothing where learning is off, but the
  /// events are still told: they mark the map.
  std::span<const Lesson> learn(const TrainingInput& input, const Sight& sight);

  const TerrainMixture& mixture() const { return mixture_; }
  const TextureModel& texture() const { return texture_; }
  /// What outlives the process.
  MixtureSnapshot snapshot() const;
  std::span<const Lesson> lessons() const { return lessons_; }

 private:
  Lesson study(const TrainingEvent& event, const Sight& sight);

  bool enabled_;
  TerrainMixture mixture_;
  TextureModel texture_;
  TrainingEventSource events_;
  TrainingPatchTracer tracer_;
  PatchPixels pixels_;
  std::vector<Lesson> lessons_;
};

}  // namespace hindsight
