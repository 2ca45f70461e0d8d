// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/float_mixture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hindsight {
namespace {

constexpr double kNegligibleShare = 6.2e-6;
constexpr double kFloatStep = 0x1p-23;
/// Relative error of the classifier's exponential, 2e-6, and of a sum of 256 of them.
constexpr double kSumError = 2e-6 + 256 * kFloatStep;

/// Each row of W (c - mean) in floats is off by at most the row's absolute sum times this: the colour's own
/// error, the roundings of colour, mean and difference (values below 512), and those of the row's products
/// and sums.
double row_error(double color_error) { return color_error + 512.0 * kFloatStep * 4.0; }

using Column = std::array<float, FloatMixture::kRows>;
/// So far away that it neither matters nor overflows.
constexpr Column kNowhere{1e6f, 1e6f, 1e6f, 1.0f, 0.0f, 1.0f, 0.0f, 0.0f, 1.0f, -1e6f};

void put(FloatMixture& table, std::size_t j, const Column& column) {
  for (std::size_t row = 0; row < column.size(); ++row) table.value[row][j] = column[row];
}

void fill_up(FloatMixture& table, std::size_t count) {
  table.count = (count + kLanes - 1) / kLanes * kLanes;
  for (std::size_t j = count; j < table.count; ++j) put(table, j, kNowhere);
}

}  // namespace

void FloatMixture::set(const MixtureLikelihood& exact, ColorSpace color_space) {
  const double gate = exact.gate();
  gate2 = static_cast<float>(gate * gate);
  const std::size_t components = exact.terms().size();
  fill_up(*this, components);
  if (components == 0) return;
  double length_error = 0.0, least_log = std::numeric_limits<double>::infinity(), most_log = -least_log;
  for (std::size_t j = 0; j < components; ++j) {
    const LikelihoodTerm& term = exact.terms()[j];
    const WhitenedGaussian& g = term.gaussian;
    const auto f = [](double v) { return static_cast<float>(v); };
    const double log_of_factor = std::log(term.factor);
    put(*this, j,
        {f(g.mean[0]), f(g.mean[1]), f(g.mean[2]), f(g.w00), f(g.w10), f(g.w11), f(g.w20), f(g.w21), f(g.w22),
         f(log_of_factor)});
    group[j] = static_cast<int>(term.label);
    const Eigen::Vector3d rows{g.w00, std::fabs(g.w10) + g.w11, std::fabs(g.w20) + std::fabs(g.w21) + g.w22};
    length_error = std::max(length_error, rows.norm() * row_error(color_float_error(color_space)));
    least_log = std::min(least_log, log_of_factor);
    most_log = std::max(most_log, log_of_factor);
  }
  // Inside the gate the best score is at least least_log - gate^2 / 2, so a component that matters is this
  // near.
  const double reach2 = gate * gate + 2.0 * (most_log - least_log + kNegligible + 1.0);
  const auto d2_error = [&](double d2) {
    return 2.0 * std::sqrt(d2) * length_error + length_error * length_error + 8.0 * kFloatStep * d2;
  };
  const double score_error =
      0.5 * d2_error(reach2) + 4.0 * kFloatStep * (reach2 + std::fabs(least_log) + std::fabs(most_log));
  const double left_out = 2.0 * kNegligibleShare * static_cast<double>(components);
  const double relative = std::expm1(score_error) + kSumError + left_out;
  error.d2_near_gate = static_cast<float>(d2_error(gate * gate + 1.0));
  error.score = static_cast<float>(2.0 * score_error + left_out);
  error.likelihood_ratio = static_cast<float>(std::min(1.0, 2.0 * relative));  // both of two may be off
}

}  // namespace hindsight
