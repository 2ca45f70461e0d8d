// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/flow_history.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hindsight {
namespace {

float mean_of(std::span<const float> values) {
  float sum = 0.0F;
  for (const float v : values) sum += v;
  return sum / static_cast<float>(values.size());
}

/// Reorders the values; of an even number of them, the mean of the two in the middle.
float median_of(std::span<float> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5F * (*middle + *std::max_element(values.begin(), middle));
}

/// The two cells between whose centres a coordinate lies, and how far it is towards the second one. Beyond
/// the outermost centres the outermost cell holds.
struct Between {
  int first;
  int second;
  float share;
};
Between between_centres(float at_px, float cell_px, int cells) {
  const float u = std::clamp(at_px / cell_px - 0.5F, 0.0F, static_cast<float>(cells - 1));
  const int first = std::min(static_cast<int>(u), std::max(cells - 2, 0));
  return {first, std::min(first + 1, cells - 1), u - static_cast<float>(first)};
}

Point2f mix(Point2f a, Point2f b, float share) {
  return {a.x_px + share * (b.x_px - a.x_px), a.y_px + share * (b.y_px - a.y_px)};
}

}  // namespace

FlowHistory::FlowHistory(const FlowHistoryParams& params, int width_px, int height_px, int max_vectors)
    : params_(params),
      width_px_(width_px),
      height_px_(height_px),
      use_median_(params.statistic == "median"),
      fill_neighbours_(params.fill == "neighbours"),
      interpolate_(params.lookup == "bilinear"),
      cell_count_(static_cast<std::size_t>(params.columns) * static_cast<std::size_t>(params.rows)) {
  newest_.columns = params.columns;
  newest_.rows = params.rows;
  newest_.cell_width_px = static_cast<float>(width_px) / static_cast<float>(params.columns);
  newest_.cell_height_px = static_cast<float>(height_px) / static_cast<float>(params.rows);
  newest_.cells.resize(cell_count_);
  first_in_cell_.resize(cell_count_ + 1);
  cell_of_vector_.resize(static_cast<std::size_t>(max_vectors));
  dx_px_.resize(static_cast<std::size_t>(max_vectors));
  dy_px_.resize(static_cast<std::size_t>(max_vectors));
  filled_.resize(cell_count_);
  filled_next_.resize(cell_count_);
  ring_.resize(cell_count_ * static_cast<std::size_t>(params.depth));
}

void FlowHistory::push(std::span<const FlowVector> flow_t_to_t_minus_1) {
  average_cells(flow_t_to_t_minus_1.first(std::min(flow_t_to_t_minus_1.size(), cell_of_vector_.size())));
  if (fill_neighbours_) fill_from_neighbours();
  store_newest();
}

void FlowHistory::clear() {
  size_ = 0;
  std::fill(newest_.cells.begin(), newest_.cells.end(), FlowCell{});
}

void FlowHistory::average_cells(std::span<const FlowVector> flow) {
  const auto limit = static_cast<float>(params_.max_vector_px * params_.max_vector_px);
  std::fill(first_in_cell_.begin(), first_in_cell_.end(), 0);
  for (std::size_t i = 0; i < flow.size(); ++i) {
    const FlowVector& v = flow[i];
    const int column = std::clamp(static_cast<int>(v.x_px / newest_.cell_width_px), 0, newest_.columns - 1);
    const int row = std::clamp(static_cast<int>(v.y_px / newest_.cell_height_px), 0, newest_.rows - 1);
    const bool keep = v.dx_px * v.dx_px + v.dy_px * v.dy_px <= limit;
    cell_of_vector_[i] = keep ? row * newest_.columns + column : -1;
    if (keep) ++first_in_cell_[static_cast<std::size_t>(cell_of_vector_[i])];
  }
  int begin = 0;
  for (int& first : first_in_cell_) begin += std::exchange(first, begin);
  for (std::size_t i = 0; i < flow.size(); ++i) {
    if (cell_of_vector_[i] < 0) continue;
    const auto place =
        static_cast<std::size_t>(first_in_cell_[static_cast<std::size_t>(cell_of_vector_[i])]++);
    dx_px_[place] = flow[i].dx_px;
    dy_px_[place] = flow[i].dy_px;
  }
  begin = 0;  // each entry now says where its cell ends
  for (std::size_t cell = 0; cell < cell_count_; ++cell) {
    const auto first = static_cast<std::size_t>(begin);
    const auto count = static_cast<std::size_t>(first_in_cell_[cell] - begin);
    begin = first_in_cell_[cell];
    const std::span dx = std::span(dx_px_).subspan(first, count),
                    dy = std::span(dy_px_).subspan(first, count);
    newest_.cells[cell] = {};
    if (count == 0) continue;
    newest_.cells[cell] = {use_median_ ? median_of(dx) : mean_of(dx),
                           use_median_ ? median_of(dy) : mean_of(dy), static_cast<int>(count)};
  }
}

/// From the rim of the empty regions inwards: each empty cell becomes the mean of those of its eight
/// neighbours that hold something.
void FlowHistory::fill_from_neighbours() {
  std::size_t missing = 0;
  for (std::size_t i = 0; i < cell_count_; ++i) {
    filled_[i] = newest_.cells[i].count > 0 ? 1 : 0;
    missing += filled_[i] == 0 ? 1U : 0U;
  }
  while (missing > 0 && missing < cell_count_) {
    filled_next_ = filled_;
    for (int row = 0; row < newest_.rows; ++row) {
      for (int column = 0; column < newest_.columns; ++column) {
        const auto index = static_cast<std::size_t>(row * newest_.columns + column);
        if (filled_[index] != 0) continue;
        float dx = 0.0F, dy = 0.0F, count = 0.0F;
        for (int r = std::max(row - 1, 0); r <= std::min(row + 1, newest_.rows - 1); ++r) {
          for (int c = std::max(column - 1, 0); c <= std::min(column + 1, newest_.columns - 1); ++c) {
            const auto other = static_cast<std::size_t>(r * newest_.columns + c);
            if (filled_[other] == 0) continue;
            dx += newest_.cells[other].dx_px;
            dy += newest_.cells[other].dy_px;
            count += 1.0F;
          }
        }
        if (count == 0.0F) continue;
        newest_.cells[index] = {dx / count, dy / count, 0};
        filled_next_[index] = 1;
        --missing;
      }
    }
    std::swap(filled_, filled_next_);
  }
}

void FlowHistory::store_newest() {
  newest_slot_ = (newest_slot_ + 1) % params_.depth;
  size_ = std::min(size_ + 1, params_.depth);
  Point2f* slot = ring_.data() + static_cast<std::size_t>(newest_slot_) * cell_count_;
  for (std::size_t i = 0; i < cell_count_; ++i) slot[i] = {newest_.cells[i].dx_px, newest_.cells[i].dy_px};
}

bool FlowHistory::inside(Point2f p) const {
  return p.x_px >= 0.0F && p.y_px >= 0.0F && p.x_px < static_cast<float>(width_px_) &&
         p.y_px < static_cast<float>(height_px_);
}

Point2f FlowHistory::flow_at(Point2f at_px, int frames_back) const {
  const int slot = (newest_slot_ - frames_back + params_.depth) % params_.depth;
  const Point2f* grid = ring_.data() + static_cast<std::size_t>(slot) * cell_count_;
  if (!interpolate_) {
    const int column = static_cast<int>(at_px.x_px / newest_.cell_width_px);
    const int row = static_cast<int>(at_px.y_px / newest_.cell_height_px);
    return grid[std::min(row, newest_.rows - 1) * newest_.columns + std::min(column, newest_.columns - 1)];
  }
  const Between x = between_centres(at_px.x_px, newest_.cell_width_px, newest_.columns);
  const Between y = between_centres(at_px.y_px, newest_.cell_height_px, newest_.rows);
  const Point2f* upper = grid + y.first * newest_.columns;
  const Point2f* lower = grid + y.second * newest_.columns;
  return mix(mix(upper[x.first], upper[x.second], x.share), mix(lower[x.first], lower[x.second], x.share),
             y.share);
}

FlowHistory::Trace FlowHistory::trace_back(Point2f from_px, int max_frames, int from_frames_back) const {
  Trace trace{from_px, from_frames_back, false};
  if (!inside(from_px) || from_frames_back < 0) return trace;
  for (int step = 0; trace.frames_back < size_; ++step) {
    const Point2f flow = flow_at(trace.point_px, trace.frames_back);
    const Point2f before{trace.point_px.x_px + flow.x_px, trace.point_px.y_px + flow.y_px};
    if (!inside(before)) {
      trace.entered_here = true;
      break;
    }
    if (step >= max_frames) break;
    trace.point_px = before;
    ++trace.frames_back;
  }
  return trace;
}

}  // namespace hindsight
