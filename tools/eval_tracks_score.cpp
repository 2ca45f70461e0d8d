// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/eval_tracks_score.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace hindsight::tools {
namespace {

constexpr double kCircle_px = 5.0;

double outside_px(Point2f p, const cv::Rect2d& box) {
  const double dx = std::max({box.x - p.x_px, 0.0, p.x_px - (box.x + box.width)});
  const double dy = std::max({box.y - p.y_px, 0.0, p.y_px - (box.y + box.height)});
  return std::hypot(dx, dy);
}

double from_middle_px(Point2f p, const cv::Rect2d& box) {
  return std::hypot(p.x_px - (box.x + 0.5 * box.width), p.y_px - (box.y + 0.5 * box.height));
}

bool over(const Track& track, const TrueBox& box) {
  return outside_px(track.at_px, box.box_px) <= kCircle_px;
}

}  // namespace

/// Hungarian algorithm with potentials, O(n^3), on the square matrix of costs that `values` fill up with
/// zeros.
double best_assignment(const std::vector<std::vector<double>>& values) {
  std::size_t n = values.size();
  for (const auto& row : values) n = std::max(n, row.size());
  const auto cost = [&](std::size_t i, std::size_t j) {
    return i < values.size() && j < values[i].size() ? -values[i][j] : 0.0;
  };
  std::vector<double> u(n + 1), v(n + 1);
  std::vector<std::size_t> row_of(n + 1), way(n + 1);
  for (std::size_t i = 1; i <= n; ++i) {
    row_of[0] = i;
    std::size_t column = 0;
    std::vector<double> least(n + 1, std::numeric_limits<double>::infinity());
    std::vector<bool> used(n + 1);
    do {
      used[column] = true;
      const std::size_t row = row_of[column];
      double delta = std::numeric_limits<double>::infinity();
      std::size_t next = 0;
      for (std::size_t j = 1; j <= n; ++j) {
        if (used[j]) continue;
        const double reduced = cost(row - 1, j - 1) - u[row] - v[j];
        if (reduced < least[j]) least[j] = reduced, way[j] = column;
        if (least[j] < delta) delta = least[j], next = j;
      }
      for (std::size_t j = 0; j <= n; ++j) {
        if (used[j]) {
          u[row_of[j]] += delta, v[j] -= delta;
        } else {
          least[j] -= delta;
        }
      }
      column = next;
    } while (row_of[column] != 0);
    for (; column != 0; column = way[column]) row_of[column] = row_of[way[column]];
  }
  double sum = 0.0;
  for (std::size_t j = 1; j <= n; ++j) sum -= cost(row_of[j] - 1, j - 1);
  return sum;
}

TrackScore::TrackScore(const TrackTruth& truth, int settle_frames)
    : truth_(truth), settle_frames_(settle_frames) {}

void TrackScore::add(std::span<const Track> tracks) {
  const auto frame = static_cast<std::size_t>(sums_.frames);
  if (frame >= truth_.frames.size()) return;
  match(tracks, truth_.frames[frame]);
  ++sums_.frames;
}

void TrackScore::match(std::span<const Track> tracks, std::span<const TrueBox> boxes) {
  // By nearness, but what was together stays together.
  std::vector<std::tuple<bool, double, std::size_t, std::size_t>> candidates;
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    if (!boxes[b].counts) continue;
    const auto last = last_track_of_.find(boxes[b].id);
    for (std::size_t t = 0; t < tracks.size(); ++t) {
      if (!over(tracks[t], boxes[b])) continue;
      const bool other = last == last_track_of_.end() || last->second != tracks[t].id;
      candidates.emplace_back(other, from_middle_px(tracks[t].at_px, boxes[b].box_px), b, t);
    }
  }
  std::sort(candidates.begin(), candidates.end());
  std::vector<bool> box_taken(boxes.size()), track_taken(tracks.size());
  const bool settled = sums_.frames >= settle_frames_;
  for (const auto& [other, distance_px, b, t] : candidates) {
    ++together_[{boxes[b].id, tracks[t].id}];
    over_something_[tracks[t].id] = true;
    if (box_taken[b] || track_taken[t]) continue;
    box_taken[b] = track_taken[t] = true;
    const auto [last, first] = last_track_of_.try_emplace(boxes[b].id, tracks[t].id);
    sums_.id_switches += last->second != tracks[t].id;
    last->second = tracks[t].id;
    ++sums_.tp, error_px_ += distance_px;
    found_ += settled;
  }
  int objects = 0;
  for (const TrueBox& box : boxes) objects += box.counts;
  judged_ += settled ? objects : 0;
  sums_.fn += objects - static_cast<int>(std::count(box_taken.begin(), box_taken.end(), true));
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    const auto over_any = [&](bool that_count) {
      return std::any_of(boxes.begin(), boxes.end(), [&](const TrueBox& box) {
        return box.counts == that_count && over(tracks[t], box);
      });
    };
    const bool spared = !track_taken[t] && over_any(false) && !over_any(true);
    over_something_.try_emplace(tracks[t].id, false);
    if (spared) over_something_[tracks[t].id] = true;
    told_ += !spared;
    sums_.fp += !spared && !track_taken[t];
  }
  sums_.tn += boxes.empty() && tracks.empty();
}

TrackFigures TrackScore::figures() const {
  TrackFigures figures = sums_;
  if (judged_ > 0) figures.recall = static_cast<double>(found_) / judged_;
  if (sums_.tp > 0) figures.mean_error_px = error_px_ / sums_.tp;
  const auto false_tracks =
      std::count_if(over_something_.begin(), over_something_.end(), [](const auto& t) { return !t.second; });
  if (sums_.frames > 0)
    figures.false_tracks_per_100_frames = 100.0 * static_cast<double>(false_tracks) / sums_.frames;
  std::map<int, std::size_t> objects, tracks;
  for (const auto& [pair, frames] : together_)
    objects.try_emplace(pair.first, objects.size()), tracks.try_emplace(pair.second, tracks.size());
  std::vector<std::vector<double>> frames_of(objects.size(), std::vector<double>(tracks.size()));
  for (const auto& [pair, frames] : together_) frames_of[objects[pair.first]][tracks[pair.second]] = frames;
  const int all = told_ + sums_.objects();
  figures.idf1 = all == 0 ? 0.0 : 2.0 * best_assignment(frames_of) / all;
  return figures;
}

}  // namespace hindsight::tools
