// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/report_mixture.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "tools/svg_chart.h"

namespace hindsight::tools {
namespace {

std::uint8_t byte_of(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

/// CIE's inverse of f: t^3 above 6/29.
double inverse_f(double t) {
  return t > 6.0 / 29.0 ? t * t * t : 3.0 * (6.0 / 29.0) * (6.0 / 29.0) * (t - 4.0 / 29.0);
}

double srgb_byte(double linear) {
  if (linear <= 0.0031308) return 255.0 * 12.92 * linear;
  return 255.0 * (1.055 * std::pow(linear, 1.0 / 2.4) - 0.055);
}

Rgb rgb_of_lab(const Eigen::Vector3d& lab) {
  const double fy = (lab[0] + 16.0) / 116.0;
  const double x = 0.95047 * inverse_f(fy + lab[1] / 500.0), y = inverse_f(fy),
               z = 1.08883 * inverse_f(fy - lab[2] / 200.0);
  return {byte_of(srgb_byte(3.2404542 * x - 1.5371385 * y - 0.4985314 * z)),
          byte_of(srgb_byte(-0.9692660 * x + 1.8760108 * y + 0.0415560 * z)),
          byte_of(srgb_byte(0.0556434 * x - 0.2040259 * y + 1.0572252 * z))};
}

double vote_sum(const MixtureComponent& component) {
  return component.votes[0] + component.votes[1] + component.votes[2];
}

std::vector<std::size_t> most_voted_first(const std::vector<MixtureComponent>& components) {
  std::vector<std::size_t> order(components.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return vote_sum(components[a]) > vote_sum(components[b]);
  });
  return order;
}

/// The channels of the chart.
struct Plane {
  int x;
  int y;
  ChartAxis x_axis;
  ChartAxis y_axis;
};

Plane plane_of(const TerrainMixture& mixture) {
  if (mixture.color_space() == ColorSpace::rgb)
    return {0, 1, {0, 255, "red [0..255]"}, {0, 255, "green [0..255]"}};
  Plane plane{1, 2, {-10, 10, "a*, green to red [CIE units]"}, {-10, 10, "b*, blue to yellow [CIE units]"}};
  const auto fit = [](ChartAxis& axis, double mean, double variance) {
    const double reach = std::sqrt(variance) + 2.0;
    axis.min = std::min(axis.min, mean - reach);
    axis.max = std::max(axis.max, mean + reach);
  };
  for (const MixtureComponent& component : mixture.components()) {
    fit(plane.x_axis, component.mean[1], component.covariance(1, 1));
    fit(plane.y_axis, component.mean[2], component.covariance(2, 2));
  }
  return plane;
}

void draw_component(SvgChart& chart, const Plane& plane, const MixtureComponent& component, ColorSpace space,
                    std::size_t index) {
  Eigen::Matrix2d covariance;
  covariance << component.covariance(plane.x, plane.x), component.covariance(plane.x, plane.y),
      component.covariance(plane.y, plane.x), component.covariance(plane.y, plane.y);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(covariance);
  const Eigen::Vector2d wide = solver.eigenvectors().col(1);
  const Rgb outline = component.label == TerrainClass::unknown ? kFaint : color_of(component.label);
  chart.ellipse(component.mean[plane.x], component.mean[plane.y], std::sqrt(solver.eigenvalues()[1]),
                std::sqrt(solver.eigenvalues()[0]), std::atan2(wide[1], wide[0]),
                screen_color(space, component.mean), outline,
                fmt::format("component {}: {}", index, name_of(component.label)));
}

}  // namespace

Rgb screen_color(ColorSpace space, const Eigen::Vector3d& mean) {
  if (space == ColorSpace::lab) return rgb_of_lab(mean);
  return {byte_of(mean[0]), byte_of(mean[1]), byte_of(mean[2])};
}

std::string mixture_table(const TerrainMixture& mixture) {
  const bool lab = mixture.color_space() == ColorSpace::lab;
  std::string html = fmt::format(
      "<table class='numbers'><tr><th>component</th><th>colour</th><th>mean {0}</th><th>standard "
      "deviations</th>"
      "<th>good</th><th>bad</th><th>lethal</th><th>class</th><th>weight [px]</th></tr>\n",
      lab ? "L* a* b*" : "R G B");
  for (const std::size_t index : most_voted_first(mixture.components())) {
    const MixtureComponent& c = mixture.components()[index];
    const Eigen::Vector3d sd = c.covariance.diagonal().cwiseSqrt();
    const Rgb color = screen_color(mixture.color_space(), c.mean);
    html += fmt::format(
        "<tr><td>{}</td><td><span class='swatch' style='background:{}'></span></td><td>{:.1f} {:.1f} "
        "{:.1f}</td>"
        "<td>{:.1f} {:.1f} {:.1f}</td><td>{:.3g}</td><td>{:.3g}</td><td>{:.3g}</td>"
        "<td><span class='label' style='background:{}'>{}</span></td><td>{:.0f}</td></tr>\n",
        index, color.hex(), c.mean[0], c.mean[1], c.mean[2], sd[0], sd[1], sd[2], c.votes[0], c.votes[1],
        c.votes[2], color_of(c.label).hex(), name_of(c.label), c.weight_px);
  }
  return html + "</table>\n";
}

std::string mixture_chart(const TerrainMixture& mixture) {
  const Plane plane = plane_of(mixture);
  // One scale for both axes: the picture is as high as its range asks for.
  constexpr double width_px = 560.0;
  const double ratio = (plane.y_axis.max - plane.y_axis.min) / (plane.x_axis.max - plane.x_axis.min);
  SvgChart chart(static_cast<int>(width_px) + 112,
                 static_cast<int>(std::clamp(width_px * ratio, 200.0, 900.0)) + 74, plane.x_axis,
                 plane.y_axis);
  for (const TerrainClass label : {TerrainClass::good, TerrainClass::bad, TerrainClass::lethal}) {
    chart.legend(name_of(label), color_of(label));
  }
  chart.legend("no class yet", kFaint);
  for (std::size_t i = 0; i < mixture.components().size(); ++i) {
    draw_component(chart, plane, mixture.components()[i], mixture.color_space(), i);
  }
  return chart.text();
}

}  // namespace hindsight::tools
