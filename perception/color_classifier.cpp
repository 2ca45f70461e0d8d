// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/color_classifier.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "perception/multiversion.h"
#include "perception/simd.h"

namespace hindsight {
namespace {

constexpr int kGroups = kLabelCount + 1;
constexpr std::int32_t kUnknown = static_cast<std::int32_t>(TerrainClass::unknown);
/// Components whose log-likelihood is this far below the best are left out (e^-12 = 6.2e-6).
constexpr float kNegligible = 12.0f;
constexpr double kNegligibleShare = 6.2e-6;
/// Ask the doubles: no label, and not one of MixtureLikelihood's.
constexpr std::int32_t kAsk = 4;
constexpr double kFloatStep = 0x1p-23;
/// Relative error of exp_of_negative and of a sum of 256 of them.
constexpr double kSumError = 2e-6 + 256 * kFloatStep;

/// x becomes e^x, for x <= 0, within 2e-6 relatively; 0 below -80. x = n ln 2 + r with |r| <= ln 2 / 2, and
/// the Taylor series of e^r.
inline void exp_of_negative(Floats& x) {
  const Ints counts = x >= -80.0f;
  const Floats clamped = counts ? x : Floats{} - 80.0f;
  const Ints n = __builtin_convertvector(clamped * 1.44269504f - 0.5f, Ints);
  const Floats nf = __builtin_convertvector(n, Floats);
  const Floats r = (clamped - nf * 0.693359375f) + nf * 2.12194440e-4f;  // ln 2 in two parts, the first exact
  Floats e = r * (1.0f / 720) + 1.0f / 120;
  e = e * r + 1.0f / 24;
  e = e * r + 1.0f / 6;
  e = e * r + 0.5f;
  e = e * r + 1.0f;
  e = e * r + 1.0f;
  const Ints power = (n + 127) << 23;  // the bits of 2^n
  Floats scale;
  std::memcpy(&scale, &power, sizeof scale);
  x = counts ? e * scale : Floats{};
}

/// A group of like colours and what to compare them with.
struct Group {
  const float* channel[3];
  std::size_t count;  ///< read up to the next multiple of kLanes
  float gate2;
  ColorClassifier::ErrorBound error;
};

/// Smallest box around the group's colours, widened by more than the floats' error.
struct Box {
  float middle[3], half[3];
};

inline Box box_around(const Group& in) {
  Box box;
  for (int k = 0; k < 3; ++k) {
    float low = in.channel[k][0], high = low;
    for (std::size_t i = 1; i < in.count; ++i) {
      const float c = in.channel[k][i];
      low = c < low ? c : low;
      high = c > high ? c : high;
    }
    box.middle[k] = 0.5f * (low + high);
    box.half[k] = 0.5f * (high - low) + 1e-3f;
  }
  return box;
}

/// Bounds of components' squared distances and log-likelihoods over a box.
struct Bounds {
  Floats d2_low[kMostComponents / kLanes], score_low[kMostComponents / kLanes],
      score_high[kMostComponents / kLanes];
  float nearest_low, nearest_high, best_low;
};

/// |W (c - mean)|^2 row by row: each row's value lies within reach of the one in the box's middle.
inline void bound(const ColorClassifier::Table& t, const Box& box, Bounds& out) {
  using Row = ColorClassifier::Table;
  Floats nearest_low = Floats{} + std::numeric_limits<float>::max(), nearest_high = nearest_low,
         best = -nearest_low;
  for (std::size_t j = 0; j < t.count; j += kLanes) {
    Floats v[Row::kRows];
    for (int row = 0; row < Row::kRows; ++row) load(v[row], &t.value[row][j]);
    const Floats x = box.middle[0] - v[Row::mean0], y = box.middle[1] - v[Row::mean1],
                 z = box.middle[2] - v[Row::mean2];
    Floats p = v[Row::w00] * x, q = v[Row::w10] * x + v[Row::w11] * y;
    Floats r = v[Row::w20] * x + v[Row::w21] * y + v[Row::w22] * z;
    absolute(p), absolute(q), absolute(r);
    absolute(v[Row::w10]), absolute(v[Row::w20]), absolute(v[Row::w21]);
    const Floats reach_p = v[Row::w00] * box.half[0],
                 reach_q = v[Row::w10] * box.half[0] + v[Row::w11] * box.half[1];
    const Floats reach_r = v[Row::w20] * box.half[0] + v[Row::w21] * box.half[1] + v[Row::w22] * box.half[2];
    const Floats p1 = p + reach_p, q1 = q + reach_q, r1 = r + reach_r;
    Floats p0 = p - reach_p, q0 = q - reach_q, r0 = r - reach_r;
    p0 = p0 > 0.0f ? p0 : Floats{}, q0 = q0 > 0.0f ? q0 : Floats{}, r0 = r0 > 0.0f ? r0 : Floats{};
    const Floats low = p0 * p0 + q0 * q0 + r0 * r0, high = p1 * p1 + q1 * q1 + r1 * r1;
    const Floats score = v[Row::log_factor] - 0.5f * high;
    nearest_low = low < nearest_low ? low : nearest_low;
    nearest_high = high < nearest_high ? high : nearest_high;
    best = score > best ? score : best;
    out.d2_low[j / kLanes] = low;
    out.score_low[j / kLanes] = score;
    out.score_high[j / kLanes] = v[Row::log_factor] - 0.5f * low;
  }
  out.nearest_low = least(nearest_low);
  out.nearest_high = least(nearest_high);
  out.best_low = -least(-best);
}

/// Whether the class of the best component surely beats each other class, whose likelihood is at most its
/// largest summand times the number of its summands; -1 if not.
inline std::int32_t sure_winner(const float best_low[kGroups], const float best_high[kGroups],
                                const int count[kGroups]) {
  std::int32_t winner = 0;
  for (std::int32_t g = 1; g < kGroups; ++g) winner = best_low[g] > best_low[winner] ? g : winner;
  for (std::int32_t g = 0; g < kGroups; ++g) {
    if (g == winner || count[g] == 0) continue;
    const auto bits = static_cast<float>(std::bit_width(static_cast<unsigned>(count[g])));
    if (best_high[g] + 0.6931472f * bits + 0.05f >= best_low[winner]) return -1;
  }
  return winner;
}

/// Decides a whole group of colours, or leaves the components that matter in `selection`.
HINDSIGHT_MULTIVERSION ColorClassifier::Outlook survey(const Group& in, const ColorClassifier::Table& terms,
                                                       ColorClassifier::Selection& selection) {
  Bounds bounds;
  bound(terms, box_around(in), bounds);
  const float surely_out = in.gate2 + in.error.d2_near_gate;
  if (bounds.nearest_low > surely_out) return {true, kUnknown};
  const bool all_inside = bounds.nearest_high < in.gate2 - in.error.d2_near_gate;
  const float gate_reach = all_inside ? -1.0f : surely_out;

  float best_low[kGroups], best_high[kGroups];
  int count[kGroups] = {};
  std::fill_n(best_low, kGroups, std::numeric_limits<float>::lowest());
  std::fill_n(best_high, kGroups, std::numeric_limits<float>::lowest());
  std::uint16_t kept[kGroups][kMostComponents];
  for (std::size_t block = 0; block < terms.count / kLanes; ++block) {
    const Floats& high = bounds.score_high[block];
    const Ints matters = (high >= bounds.best_low - kNegligible) | (bounds.d2_low[block] <= gate_reach);
    if (!any(matters)) continue;
    for (std::size_t l = 0; l < kLanes; ++l) {
      if (matters[l] == 0) continue;
      const std::size_t j = block * kLanes + l;
      const int g = terms.group[j];
      const float low = bounds.score_low[block][l];
      best_low[g] = low > best_low[g] ? low : best_low[g];
      best_high[g] = high[l] > best_high[g] ? high[l] : best_high[g];
      kept[g][count[g]++] = static_cast<std::uint16_t>(j);
    }
  }
  const std::int32_t winner = all_inside ? sure_winner(best_low, best_high, count) : -1;
  if (winner >= 0) return {true, winner};
  std::uint16_t* end = selection.column;
  for (int g = 0; g < kGroups; ++g) {
    end = std::copy_n(kept[g], count[g], end);
    selection.group_end[g] = static_cast<std::size_t>(end - selection.column);
  }
  return {false, kAsk};
}

/// Labels of the group's colours; kAsk where the floats cannot tell.
HINDSIGHT_MULTIVERSION void classify_lanes(const Group& in, const ColorClassifier::Table& terms,
                                           const ColorClassifier::Selection& selection,
                                           std::int32_t* labels) {
  using Row = ColorClassifier::Table;
  Floats score[kMostComponents];
  float log_count[kGroups];
  for (int g = 0; g < kGroups; ++g) {
    const std::size_t count = selection.group_end[g] - (g == 0 ? 0 : selection.group_end[g - 1]);
    log_count[g] = 0.6931472f * static_cast<float>(std::bit_width(count));  // at least its logarithm
  }
  const float surely_out = in.gate2 + in.error.d2_near_gate, surely_in = in.gate2 - in.error.d2_near_gate;
  for (std::size_t i = 0; i < in.count; i += kLanes) {
    Floats cx, cy, cz;
    load(cx, in.channel[0] + i), load(cy, in.channel[1] + i), load(cz, in.channel[2] + i);
    Floats nearest = Floats{} + std::numeric_limits<float>::max(), best = -nearest, group_best[kGroups];
    for (std::size_t g = 0, j = 0; g < kGroups; ++g) {
      Floats largest = Floats{} + std::numeric_limits<float>::lowest();
      for (; j < selection.group_end[g]; ++j) {
        const std::size_t column = selection.column[j];
        const auto v = [&](Row::Row row) { return terms.value[row][column]; };
        const Floats x = cx - v(Row::mean0), y = cy - v(Row::mean1), z = cz - v(Row::mean2);
        const Floats p = v(Row::w00) * x, q = v(Row::w10) * x + v(Row::w11) * y;
        const Floats r = v(Row::w20) * x + v(Row::w21) * y + v(Row::w22) * z;
        const Floats d2 = p * p + q * q + r * r;  // (5.2)
        score[j] = v(Row::log_factor) - 0.5f * d2;
        nearest = d2 < nearest ? d2 : nearest;
        larger_of(largest, score[j]);
      }
      group_best[g] = largest;
      larger_of(best, largest);
    }

    // A class whose best summand beats all of another class together needs no sums.
    Ints rivals = Ints{}, winner = Ints{};
    const Floats beaten = best - in.error.score;
    for (int g = 0; g < kGroups; ++g) {
      const Ints leads = group_best[g] == best;
      winner |= leads & g;
      rivals -= (group_best[g] + log_count[g] >= beaten) | leads;  // truth is -1
    }
    if (any((rivals != 1) & (nearest <= surely_out))) {
      Floats sum[kGroups], top = Floats{};  // (5.1), relative to the best summand
      for (std::size_t g = 0, j = 0; g < kGroups; ++g) {
        sum[g] = Floats{};
        for (; j < selection.group_end[g]; ++j) {
          Floats share = score[j] - best;
          if (!any(share >= -kNegligible)) continue;
          exp_of_negative(share);
          sum[g] += share;
        }
        larger_of(top, sum[g]);
      }
      winner = rivals = Ints{};
      for (int g = 0; g < kGroups; ++g) {
        winner |= (sum[g] == top) & g;
        rivals -= sum[g] >= top * (1.0f - in.error.likelihood_ratio);
      }
    }
    const Ints inside = ((rivals == 1) & (nearest < surely_in)) ? winner : Ints{} + kAsk;
    store(labels + i, nearest > surely_out ? Ints{} + kUnknown : inside);
  }
}

/// Each row of W (c - mean) in floats is off by at most the row's absolute sum times this: the colour's own
/// error, the roundings of colour, mean and difference (values below 512), and those of the row's products
/// and sums.
double row_error(double color_error) { return color_error + 512.0 * kFloatStep * 4.0; }

using Column = std::array<float, ColorClassifier::Table::kRows>;
/// So far away that it neither matters nor overflows.
constexpr Column kNowhere{1e6f, 1e6f, 1e6f, 1.0f, 0.0f, 1.0f, 0.0f, 0.0f, 1.0f, -1e6f};

void put(ColorClassifier::Table& table, std::size_t j, const Column& column) {
  for (std::size_t row = 0; row < column.size(); ++row) table.value[row][j] = column[row];
}

}  // namespace

ColorClassifier::ColorClassifier(std::size_t most_colors)
    : exact_(kMostComponents), found_(most_colors + kLanes) {
  for (std::vector<float>& channel : channels_) channel.resize(most_colors + kLanes);
}

void ColorClassifier::set(const TerrainMixture& mixture) {
  exact_.set(mixture.components(), mixture.params().gate);
  color_space_ = mixture.color_space();
  const double gate = mixture.params().gate;
  gate2_ = static_cast<float>(gate * gate);
  const std::size_t count = exact_.terms().size();
  terms_.count = (count + kLanes - 1) / kLanes * kLanes;
  for (std::size_t j = count; j < terms_.count; ++j) put(terms_, j, kNowhere);
  if (count == 0) return;
  double length_error = 0.0, least_log = std::numeric_limits<double>::infinity(), most_log = -least_log;
  for (std::size_t j = 0; j < count; ++j) {
    const LikelihoodTerm& term = exact_.terms()[j];
    const WhitenedGaussian& g = term.gaussian;
    const auto f = [](double v) { return static_cast<float>(v); };
    const double log_factor = std::log(term.factor);
    put(terms_, j,
        {f(g.mean[0]), f(g.mean[1]), f(g.mean[2]), f(g.w00), f(g.w10), f(g.w11), f(g.w20), f(g.w21), f(g.w22),
         f(log_factor)});
    terms_.group[j] = static_cast<int>(term.label);
    const Eigen::Vector3d rows{g.w00, std::fabs(g.w10) + g.w11, std::fabs(g.w20) + std::fabs(g.w21) + g.w22};
    length_error = std::max(length_error, rows.norm() * row_error(color_float_error(color_space_)));
    least_log = std::min(least_log, log_factor);
    most_log = std::max(most_log, log_factor);
  }
  // Inside the gate the best score is at least least_log - gate^2 / 2, so a component that matters is this
  // near.
  const double reach2 = gate * gate + 2.0 * (most_log - least_log + kNegligible + 1.0);
  const auto d2_error = [&](double d2) {
    return 2.0 * std::sqrt(d2) * length_error + length_error * length_error + 8.0 * kFloatStep * d2;
  };
  const double score_error =
      0.5 * d2_error(reach2) + 4.0 * kFloatStep * (reach2 + std::fabs(least_log) + std::fabs(most_log));
  error_.d2_near_gate = static_cast<float>(d2_error(gate * gate + 1.0));
  const double relative =
      std::expm1(score_error) + kSumError + 2.0 * kNegligibleShare * static_cast<double>(count);
  error_.score = static_cast<float>(2.0 * score_error + 2.0 * kNegligibleShare * static_cast<double>(count));
  error_.likelihood_ratio = static_cast<float>(std::min(1.0, 2.0 * relative));  // both of two may be off
}

void ColorClassifier::load(std::span<const std::uint32_t> keys) {
  keys_ = keys;
  float* const channels[3] = {channels_[0].data(), channels_[1].data(), channels_[2].data()};
  colors_of(color_space_, keys.data(), static_cast<int>(keys.size()), channels);
}

void ColorClassifier::classify(std::size_t begin, std::size_t end, std::uint8_t* labels) {
  const std::size_t count = end - begin;
  const Group group{
      {&channels_[0][begin], &channels_[1][begin], &channels_[2][begin]}, count, gate2_, error_};
  const Outlook outlook = survey(group, terms_, selection_);
  if (outlook.decided) {
    std::fill_n(labels, count, static_cast<std::uint8_t>(outlook.label));
    return;
  }
  classify_lanes(group, terms_, selection_, found_.data());
  for (std::size_t i = 0; i < count; ++i) {
    labels[i] = static_cast<std::uint8_t>(found_[i]);
    if (found_[i] != kAsk) continue;
    const auto byte = [key = keys_[begin + i]](int shift) {
      return static_cast<std::uint8_t>(key >> shift & 255u);
    };
    labels[i] =
        static_cast<std::uint8_t>(exact_.classify(color_of(color_space_, byte(0), byte(8), byte(16))));
  }
}

}  // namespace hindsight
