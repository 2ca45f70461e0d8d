// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <opencv2/core/types.hpp>
#include <vector>

namespace hindsight::tools {

/// An object that truth knows of in one frame.
struct TrueBox {
  int id = 0;
  cv::Rect2d box_px;
  bool counts = true;  ///< false: to be found or not, as one likes (it stands, say)
};

/// What moves in a sequence, frame by frame.
struct TrackTruth {
  bool complete = false;  ///< everything that moves is in it; else other things may move too
  std::vector<std::vector<TrueBox>> frames;  ///< may be shorter than the sequence: the rest is not known
};

/// Two forms, told apart by the number of columns. Four, "x,y,w,h", one line a frame, NaN where the object is
/// not in view (UAV123): one of the things that move. Six or more, "frame,id,x,y,w,h[,counts,...]", frames
/// from 1 (MOTChallenge): all of them. An empty file, or nothing but NaN: nothing moves, in any of `frames`.
/// All numbers are multiplied by `scale`. FatalError 66 for a file that cannot be read, 65 for a line that is
/// neither; says so on standard error where there are more or fewer lines than frames.
TrackTruth read_track_truth(const std::filesystem::path& file, double scale, int frames);

}  // namespace hindsight::tools
