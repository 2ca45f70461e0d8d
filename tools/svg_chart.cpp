// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/svg_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "tools/html_text.h"

namespace hindsight::tools {
namespace {

constexpr double kLeftPx = 96.0;
constexpr double kRightPx = 16.0;
constexpr double kTopPx = 30.0;
constexpr double kBottomPx = 44.0;
constexpr double kLegendLetterPx = 7.0;

double nice_step(double range, int about) {
  const double rough = range / about;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough) return factor * power;
  }
  return 10.0 * power;
}

std::string title(const std::string& tip) {
  return tip.empty() ? "" : "<title>" + escape_html(tip) + "</title>";
}

/// The points of one pixel column.
struct Column {
  long index = 0;
  double first = 0.0, low = 0.0, high = 0.0, last = 0.0;
};

void append_column(std::string& points, const Column& column) {
  const auto x = static_cast<double>(column.index);
  points += fmt::format("{:.0f},{:.1f} ", x, column.first);
  if (column.low < std::min(column.first, column.last))
    points += fmt::format("{:.0f},{:.1f} ", x, column.low);
  if (column.high > std::max(column.first, column.last))
    points += fmt::format("{:.0f},{:.1f} ", x, column.high);
  if (column.last != column.first) points += fmt::format("{:.0f},{:.1f} ", x, column.last);
}

}  // namespace

std::vector<double> axis_marks(double min, double max, int about) {
  std::vector<double> marks;
  if (!(max > min)) return marks;
  const double step = nice_step(max - min, about);
  for (double i = std::ceil(min / step - 1e-9); i * step <= max + 1e-9 * step; ++i) marks.push_back(i * step + 0.0);
  return marks;
}

SvgChart::SvgChart(int width_px, int height_px, ChartAxis x, ChartAxis y)
    : width_px_(width_px), height_px_(height_px), x_(std::move(x)), y_(std::move(y)), legend_x_px_(kLeftPx) {
  if (!(x_.max > x_.min)) x_.max = x_.min + 1.0;
  if (!(y_.max > y_.min)) y_.max = y_.min + 1.0;
}

double SvgChart::x_px(double x) const {
  return kLeftPx + (x - x_.min) / (x_.max - x_.min) * (width_px_ - kLeftPx - kRightPx);
}

double SvgChart::y_px(double y) const {
  const double share = (y - y_.min) / (y_.max - y_.min);
  const double high = height_px_ - kTopPx - kBottomPx;
  return kTopPx + (row_names_.empty() ? 1.0 - share : share) * high;
}

void SvgChart::name_rows(std::span<const std::string> names) {
  row_names_.assign(names.begin(), names.end());
  y_.min = 0.0;
  y_.max = static_cast<double>(std::max<std::size_t>(names.size(), 1));
}

void SvgChart::line(std::span<const double> x, std::span<const double> y, Rgb color,
                    const std::string& name) {
  std::string points;
  std::optional<Column> column;
  const auto finish = [&] {
    if (column) append_column(points, *column);
    column.reset();
  };
  const auto end_line = [&] {
    finish();
    if (!points.empty()) {
      body_ += fmt::format("<polyline points='{}' fill='none' stroke='{}' stroke-width='1.4'/>\n", points,
                           color.hex());
    }
    points.clear();
  };
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (std::isnan(y[i])) {
      end_line();
      continue;
    }
    const long index = std::lround(x_px(x[i]));
    const double at = y_px(std::clamp(y[i], y_.min, y_.max));
    if (column && column->index != index) finish();
    if (!column) column = Column{index, at, at, at, at};
    column->low = std::min(column->low, at);
    column->high = std::max(column->high, at);
    column->last = at;
  }
  end_line();
  legend(name, color);
}

void SvgChart::box(double x_from, double x_to, double y_from, double y_to, Rgb color, const std::string& tip,
                   double opacity) {
  const double left = x_px(x_from), top = std::min(y_px(y_from), y_px(y_to));
  body_ += fmt::format(
      "<rect x='{:.2f}' y='{:.2f}' width='{:.2f}' height='{:.2f}' fill='{}' fill-opacity='{}'>{}</rect>\n",
      left, top, x_px(x_to) - left, std::abs(y_px(y_to) - y_px(y_from)), color.hex(), opacity, title(tip));
}

void SvgChart::vertical(double x, Rgb color, const std::string& tip, const std::string& label) {
  const double at = x_px(x);
  body_ += fmt::format(
      "<line x1='{0:.1f}' x2='{0:.1f}' y1='{1}' y2='{2}' stroke='{3}' stroke-width='1.5'>{4}</line>\n", at,
      kTopPx, height_px_ - kBottomPx, color.hex(), title(tip));
  if (label.empty()) return;
  body_ += fmt::format("<text x='{:.1f}' y='{}' text-anchor='middle' fill='{}'>{}</text>\n", at, kTopPx - 4.0,
                       color.hex(), escape_html(label));
}

void SvgChart::horizontal(double y, Rgb color, const std::string& label) {
  const double at = y_px(y);
  body_ += fmt::format(
      "<line x1='{}' x2='{}' y1='{at:.1f}' y2='{at:.1f}' stroke='{color}' stroke-dasharray='6 4'/>"
      "<text x='{}' y='{:.1f}' text-anchor='end' fill='{color}'>{}</text>\n",
      kLeftPx, width_px_ - kRightPx, width_px_ - kRightPx - 4.0, at - 4.0, escape_html(label),
      fmt::arg("at", at), fmt::arg("color", color.hex()));
}

void SvgChart::ellipse(double x, double y, double half_x, double half_y, double angle_rad, Rgb fill,
                       Rgb stroke, const std::string& tip) {
  const double wide = x_px(x_.min + half_x) - x_px(x_.min),
               high = std::abs(y_px(y_.min + half_y) - y_px(y_.min));
  body_ += fmt::format(
      "<ellipse cx='{x:.1f}' cy='{y:.1f}' rx='{:.1f}' ry='{:.1f}' transform='rotate({:.1f} {x:.1f} {y:.1f})' "
      "fill='{}' fill-opacity='0.75' stroke='{}' stroke-width='2.5'>{}</ellipse>\n",
      wide, high, -angle_rad * 180.0 / M_PI, fill.hex(), stroke.hex(), title(tip), fmt::arg("x", x_px(x)),
      fmt::arg("y", y_px(y)));
}

void SvgChart::picture(const std::string& file, double x_from, double x_to, double y_from, double y_to) {
  const double left = x_px(x_from), top = std::min(y_px(y_from), y_px(y_to));
  body_ += fmt::format(
      "<image href='{}' x='{:.1f}' y='{:.1f}' width='{:.1f}' height='{:.1f}' preserveAspectRatio='none'/>\n",
      escape_html(file), left, top, x_px(x_to) - left, std::abs(y_px(y_to) - y_px(y_from)));
}

void SvgChart::legend(const std::string& name, Rgb color) {
  if (name.empty()) return;
  axes_ += fmt::format(
      "<rect x='{:.0f}' y='7' width='12' height='12' fill='{}' stroke='{}'/><text x='{:.0f}' "
      "y='17'>{}</text>\n",
      legend_x_px_, color.hex(), kFaint.hex(), legend_x_px_ + 17.0, escape_html(name));
  legend_x_px_ += 34.0 + kLegendLetterPx * static_cast<double>(name.size());
}

void SvgChart::draw_axes() {
  const double bottom = height_px_ - kBottomPx, right = width_px_ - kRightPx;
  for (const double mark : axis_marks(x_.min, x_.max, 10)) {
    axes_ += fmt::format(
        "<line x1='{0:.1f}' x2='{0:.1f}' y1='{1}' y2='{2}' stroke='{3}'/><text x='{0:.1f}' y='{4}' "
        "text-anchor='middle'>{5:.6g}</text>\n",
        x_px(mark), bottom, bottom + 5.0, kInk.hex(), bottom + 18.0, mark);
  }
  if (row_names_.empty()) {
    for (const double mark : axis_marks(y_.min, y_.max, 5)) {
      axes_ += fmt::format(
          "<line x1='{0}' x2='{1}' y1='{2:.1f}' y2='{2:.1f}' stroke='{3}'/><text x='{4}' y='{5:.1f}' "
          "text-anchor='end'>{6:.6g}</text>\n",
          kLeftPx - 5.0, kLeftPx, y_px(mark), kInk.hex(), kLeftPx - 8.0, y_px(mark) + 4.0, mark);
    }
  } else {
    draw_row_names();
  }
  axes_ += fmt::format("<rect x='{}' y='{}' width='{}' height='{}' fill='none' stroke='{}'/>\n", kLeftPx,
                       kTopPx, right - kLeftPx, bottom - kTopPx, kInk.hex());
  axes_ += fmt::format("<text x='{}' y='{}' text-anchor='middle'>{}</text>\n", (kLeftPx + right) / 2,
                       height_px_ - 6, escape_html(x_.label));
  const double middle = (kTopPx + bottom) / 2;
  axes_ +=
      fmt::format("<text x='14' y='{0}' text-anchor='middle' transform='rotate(-90 14 {0})'>{1}</text>\n",
                  middle, escape_html(y_.label));
}

void SvgChart::draw_row_names() {
  for (std::size_t row = 0; row < row_names_.size(); ++row) {
    axes_ += fmt::format("<text x='{}' y='{:.1f}' text-anchor='end'>{}</text>\n", kLeftPx - 8.0,
                         y_px(static_cast<double>(row) + 0.5) + 4.0, escape_html(row_names_[row]));
  }
}

std::string SvgChart::text() const {
  SvgChart finished = *this;
  finished.draw_axes();
  return fmt::format(
      "<svg viewBox='0 0 {0} {1}' width='{0}' height='{1}' xmlns='http://www.w3.org/2000/svg' "
      "font-family='sans-serif' font-size='12' fill='{2}'>\n{3}{4}</svg>\n",
      width_px_, height_px_, kInk.hex(), finished.body_, finished.axes_);
}

}  // namespace hindsight::tools
