// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Thesis 5.2.2, scene segmentation: does reverse optical flow make better segmentations?
#pragma once

#include <string>

namespace hindsight::tools {

struct SegmentationExperiment {
  std::string course;
  std::string folder;
  int drives = 3;
  int bumps = 4;
  int frames = 304;   ///< labelled ones, over all drives
  int every = 10;     ///< of the frames after the last bump, one is labelled
  unsigned seed = 1;  ///< of the first drive's world
};

/// Drives, judges, and writes segmentation.json, .md, .png and each arm's mixture after the last drive
/// (segmentation_ARM.mixture). Returns an exit code.
int run_segmentation_experiment(const SegmentationExperiment& experiment);

}  // namespace hindsight::tools
