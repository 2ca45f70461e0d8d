// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/terrain_mixture.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "config/exit_code.h"
#include "perception/mixture_start.h"

namespace hindsight {
namespace {

/// A new component counts as if so many pixels had shown its first spread.
constexpr double kNewComponentWeight_px = 10.0;
/// One event is one thing: it may make at most this share of all components, or a speckled patch at a narrow
/// gate would wipe out what was learned before.
constexpr int kEventShare = 4;

double total_votes(const MixtureComponent& c) { return std::accumulate(c.votes.begin(), c.votes.end(), 0.0); }

/// sum over n of x^n / ((a + 1) (a + 2) ... (a + n)): the lower incomplete gamma function without its factor.
double gamma_series(double a, double x) {
  double sum = 1.0, term = 1.0;
  for (double n = a + 1.0; term > sum * 1e-17; n += 1.0) sum += term *= x / n;
  return sum;
}

/// What is left of a 3-D Gaussian's variance inside Mahalanobis distance `gate`: P(chi2_5 < gate^2) /
/// P(chi2_3 < gate^2), that is 0.15 at 0.9 and 0.92 at 3. A component updated from the pixels inside its gate
/// shrinks by it each time.
double scatter_kept(double gate) {
  const double x = 0.5 * gate * gate;
  return x / 2.5 * gamma_series(2.5, x) / gamma_series(1.5, x);
}

}  // namespace

TerrainClass vote_label(const std::array<double, kLabelCount>& votes, double min_votes) {
  const double total = std::accumulate(votes.begin(), votes.end(), 0.0);
  if (total <= 0.0 || total < min_votes) return TerrainClass::unknown;
  std::size_t best = 0;
  for (std::size_t i = 1; i < votes.size(); ++i) {
    if (votes[i] >= votes[best]) best = i;
  }
  return static_cast<TerrainClass>(best);
}

TerrainMixture::TerrainMixture(const MixtureParams& params)
    : params_(params),
      color_space_(parse_color_space(params.color_space)),
      scatter_kept_(params.covariance_update == "unbiased" ? scatter_kept(params.gate) : 1.0) {
  const auto capacity = static_cast<std::size_t>(params_.max_components);
  if (params_.class_density == "shares" && capacity > kMostSharedComponents) {
    throw FatalError(kExitConfiguration,
                     fmt::format("mixture.max_components: {}, at most {} where class_density = \"shares\"",
                                 capacity, kMostSharedComponents));
  }
  components_.reserve(capacity);
  whitened_.reserve(capacity);
  evidence_.reserve(capacity);
  newcomers_.reserve(capacity / kEventShare + 1);
  taken_.reserve(capacity / kEventShare + 1);
}

void TerrainMixture::start(std::span<const std::uint8_t> bgr, int width_px, int height_px) {
  const std::vector<MixtureComponent> clusters = start_components(bgr, width_px, height_px, params_);
  if (!clusters.empty()) restore({color_space_, clusters});
}

TerrainMixture::TrainingReport TerrainMixture::train(std::span<const std::array<std::uint8_t, 3>> bgr_pixels,
                                                     TerrainClass label) {
  TrainingReport report;
  if (bgr_pixels.empty() || label == TerrainClass::unknown) return report;
  report.pixels = static_cast<int>(bgr_pixels.size());
  evidence_.assign(components_.size(), Evidence{});
  newcomers_.clear();
  taken_.clear();
  const auto collect_all = [&](bool may_begin) {
    report.left_out = 0;
    for (const auto& [b, g, r] : bgr_pixels)
      report.left_out += !collect(color_of(color_space_, b, g, r), may_begin);
  };
  collect_all(true);
  const double fewest_px = params_.new_component_share * report.pixels;
  if (std::erase_if(newcomers_, [&](const Newcomer& n) { return n.evidence.count_px < fewest_px; }) > 0) {
    // The pixels that those had drawn from their neighbours go back, or the neighbours would shrink.
    std::ranges::fill(evidence_, Evidence{});
    for (Newcomer& n : newcomers_) n.evidence = Evidence{};
    collect_all(false);
  }

  const double vote_px = params_.vote_unit == "event" ? 1.0 / report.pixels : 1.0;
  double most_px = 0.0;
  const auto update = [&](std::size_t index, const MixtureComponent& component, const Evidence& evidence) {
    place(index, learn(component, evidence, label, evidence.count_px * vote_px));
    if (evidence.count_px <= most_px) return;
    most_px = evidence.count_px;
    report.updated_component = static_cast<int>(index);
  };
  for (std::size_t i = 0; i < evidence_.size(); ++i) {
    if (evidence_[i].count_px > 0.0) update(i, components_[i], evidence_[i]);
  }
  for (const Newcomer& n : newcomers_) update(room(report), first_shape(n.whitened.mean), n.evidence);
  if (most_px > 0.0) ++version_;
  return report;
}

void TerrainMixture::Evidence::add(const Eigen::Vector3d& offset) {
  count_px += 1.0;
  offset_sum += offset;
  square_sum += offset * offset.transpose();
}

/// Gives one pixel to the nearest component, or to a newcomer beyond the gate of all; false if there may be
/// no more.
bool TerrainMixture::collect(const Eigen::Vector3d& color, bool may_begin) {
  double least_d2 = params_.gate * params_.gate;
  Evidence* nearest = nullptr;
  const Eigen::Vector3d* mean = nullptr;
  const auto consider = [&](const WhitenedGaussian& gaussian, Evidence& evidence) {
    const double d2 = gaussian.squared_distance(color);  // (5.2)
    if (d2 > least_d2 || (nearest != nullptr && d2 == least_d2)) return;
    least_d2 = d2;
    nearest = &evidence;
    mean = &gaussian.mean;
  };
  for (std::size_t i = 0; i < evidence_.size(); ++i) consider(whitened_[i], evidence_[i]);
  // Newcomers take only what no component claims: they would clip the components' flanks otherwise.
  if (nearest == nullptr) {
    for (Newcomer& n : newcomers_) consider(n.whitened, n.evidence);
  }
  if (nearest != nullptr) {
    nearest->add(color - *mean);
    return true;
  }
  if (!may_begin || static_cast<int>(newcomers_.size()) * kEventShare >= params_.max_components) return false;
  const MixtureComponent shape = first_shape(color);
  newcomers_.push_back({whiten(shape.mean, shape.covariance), {}});
  newcomers_.back().evidence.add(Eigen::Vector3d::Zero());
  return true;
}

MixtureComponent TerrainMixture::first_shape(const Eigen::Vector3d& mean) const {
  MixtureComponent shape;
  shape.mean = mean;
  shape.covariance *= std::max(params_.new_component_sd * params_.new_component_sd, params_.eigenvalue_floor);
  shape.weight_px = kNewComponentWeight_px;
  return shape;
}

/// Where a newcomer goes: to the end, or else to the place of the component with the fewest votes, then the
/// fewest pixels, then the first; never to that of another newcomer of the same event, of which there are
/// fewer than places.
std::size_t TerrainMixture::room(TrainingReport& report) {
  ++report.new_components;
  if (static_cast<int>(components_.size()) < params_.max_components) {
    components_.emplace_back();
    whitened_.emplace_back();
    return taken_.emplace_back(components_.size() - 1);
  }
  ++report.replaced_components;
  std::size_t least = components_.size();
  for (std::size_t i = 0; i < components_.size(); ++i) {
    if (std::ranges::find(taken_, i) != taken_.end()) continue;
    const auto rank = [&](std::size_t j) {
      return std::pair(total_votes(components_[j]), components_[j].weight_px);
    };
    if (least == components_.size() || rank(i) < rank(least)) least = i;
  }
  return taken_.emplace_back(least);
}

/// Mean and covariance of the pixels known so far and those of the event taken together, and the event's
/// votes. Beyond memory_votes all votes fade alike, so that what the latest events say can still turn the
/// label.
MixtureComponent TerrainMixture::learn(MixtureComponent component, const Evidence& evidence,
                                       TerrainClass label, double votes) const {
  const double old_px = component.weight_px, new_px = evidence.count_px, all_px = old_px + new_px;
  const Eigen::Vector3d shift = evidence.offset_sum / new_px;
  const Eigen::Matrix3d scatter = evidence.square_sum - new_px * shift * shift.transpose();
  const Eigen::Matrix3d pooled = (old_px * component.covariance + scatter / scatter_kept_ +
                                  old_px * new_px / all_px * shift * shift.transpose()) /
                                 all_px;
  component.mean += new_px / all_px * shift;
  component.covariance = floor_eigenvalues(0.5 * (pooled + pooled.transpose()), params_.eigenvalue_floor);
  component.weight_px = std::min(all_px, params_.memory_px);

  component.votes[static_cast<std::size_t>(label)] += votes;
  const double total = total_votes(component);
  if (total > params_.memory_votes) {
    for (double& v : component.votes) v *= params_.memory_votes / total;
  }
  component.label = vote_label(component.votes, params_.min_votes);
  return component;
}

void TerrainMixture::place(std::size_t index, const MixtureComponent& component) {
  components_[index] = component;
  whitened_[index] = whiten(component.mean, component.covariance);
}

std::string TerrainMixture::restore(const MixtureSnapshot& saved) {
  if (saved.color_space != color_space_)
    return "the mixture was saved in another colour space than color_space = " + params_.color_space;
  if (saved.components.size() > static_cast<std::size_t>(params_.max_components)) {
    return "the mixture has " + std::to_string(saved.components.size()) +
           " components, max_components allows " + std::to_string(params_.max_components);
  }
  components_.resize(saved.components.size());
  whitened_.resize(saved.components.size());
  for (std::size_t i = 0; i < components_.size(); ++i) {
    MixtureComponent component = saved.components[i];
    component.covariance = floor_eigenvalues(component.covariance, params_.eigenvalue_floor);
    component.label = vote_label(component.votes, params_.min_votes);
    place(i, component);
  }
  ++version_;
  return {};
}

}  // namespace hindsight
