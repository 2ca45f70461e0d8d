// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Mixture of Gaussians over colour that learns from what the robot touched (thesis 5.1).
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "config/params.h"
#include "perception/color_space.h"
#include "perception/terrain_class.h"
#include "perception/texture_model.h"
#include "perception/whitened_gaussian.h"

namespace hindsight {

constexpr std::size_t kMostComponents = 256;
/// Where a component counts both for good ground and for obstacles, there may be this many.
constexpr std::size_t kMostSharedComponents = kMostComponents / 2;

/// "colour units" below: of the colour space, so 0..255 a channel for rgb and CIE units for lab.
///
/// The defaults were measured by training online, with up to six 16 x 16 px events a frame from the labelled
/// nearest rows, and comparing the labels of far 8 x 8 px blocks (traversable or not): AUROC over off-road
/// stills in three orders, and their mean; balanced accuracy; share of unknown pixels | AUROC over a trail
/// run.
///   the thesis' values, 256 components  .777 .812 .834  .807  .726  61 % | .9991
///   rgb, K = 16, gate 3                 .824 .765 .835  .808  .708   9 % | .9979
///   rgb, K = 32, gate 3 (default)       .811 .795 .827  .811  .714  11 % | .9991
///   rgb, K = 32, gate 3.5               .817 .773 .825  .805  .706   6 % | .9994
///   lab, K = 32, gate 3, sd 6, floor 2  .781 .774 .811  .789  .700   8 % | .9986
/// The order of the stills moves each row by 0.06, so only two things are plain: the narrow gate leaves most
/// of a frame unlabelled, and lab gains nothing in online training, though it did in batch training.
struct MixtureParams {
  std::string color_space = "rgb";
  int start_components = 32;
  int max_components = 64;
  double gate = 3.0;
  double eigenvalue_floor = 4.0;
  double new_component_sd = 10.0;
  double new_component_share = 0.02;
  std::string covariance_update = "unbiased";
  double memory_px = 20000.0;
  std::string vote_unit = "event";
  double memory_votes = 5.0;
  double min_votes = 0.05;
  std::string class_density = "shares";
  int seed = 1;

  void visit(auto&& param) {
    param("color_space", color_space, Choices{"rgb", "lab"}, "space of the mixture; thesis: rgb");
    param("start_components", start_components, Range{1, 64}, "K of the K-means start; thesis: 16");
    param("max_components", max_components, Range{4, kMostComponents},
          "beyond it a new component replaces the least voted");
    param("gate", gate, Range{0.5, 6.0},
          "Mahalanobis distance beyond which a colour is unknown; thesis: 0.9");
    param("eigenvalue_floor", eigenvalue_floor, Range{0.1, 400.0},
          "least variance in any direction [colour units^2]");
    param("new_component_sd", new_component_sd, Range{0.5, 50.0},
          "standard deviation of a component made for a new colour [colour units]");
    param("new_component_share", new_component_share, Range{0.0, 1.0},
          "share of an event's pixels that a new component must hold, or its pixels are left out; thesis: 0");
    param("covariance_update", covariance_update, Choices{"raw", "unbiased"},
          "unbiased makes up for the scatter that the gate cuts off; thesis: raw");
    param("memory_px", memory_px, Range{100.0, 1e9},
          "pixels after which a component's mean and covariance forget the oldest; thesis: never, 1e9");
    param("vote_unit", vote_unit, Choices{"event", "pixel"},
          "what one training event is worth: one vote shared by its pixels, or one each; thesis: pixel");
    param("memory_votes", memory_votes, Range{1.0, 1e9},
          "votes after which a component forgets the oldest; thesis: never, 1e9");
    param("min_votes", min_votes, Range{0.0, 1e3},
          "votes below which a component has no class yet; thesis: 0");
    param("class_density", class_density, Choices{"shares", "labels"},
          "shares: a component counts for good ground and for obstacles by its share of either's votes; "
          "labels: for its own label alone, all alike (5.1), the thesis");
    param("seed", seed, Range{0, 2147483647}, "of the K-means start");
  }
};

/// One Gaussian with the votes that training events gave it.
struct MixtureComponent {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();            ///< [colour units]
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();  ///< symmetric, eigenvalues at or over the floor
  double weight_px = 0.0;                      ///< pixels behind mean and covariance, at most memory_px
  std::array<double, kLabelCount> votes{};     ///< good, bad, lethal
  TerrainClass label = TerrainClass::unknown;  ///< follows from the votes: see vote_label

  bool operator==(const MixtureComponent&) const = default;
};

/// The class with most votes; of equal ones the more severe. `unknown` where there are no votes, or fewer
/// than `min_votes` together: a handful of stray pixels of one event says nothing about a component.
TerrainClass vote_label(const std::array<double, kLabelCount>& votes, double min_votes);

/// What a saved mixture is: everything that training has to go on from.
struct MixtureSnapshot {
  ColorSpace color_space = ColorSpace::rgb;
  std::vector<MixtureComponent> components;
  TextureVotes texture{};  ///< learned beside it
};

/// Not thread safe. Allocates at construction only (start() too uses scratch memory of its own, once).
class TerrainMixture {
 public:
  /// FatalError(78) for more components than class_density allows.
  explicit TerrainMixture(const MixtureParams& params);

  /// Whether there are components: after start(), restore() or the first training event.
  bool started() const { return !components_.empty(); }

  /// K-means over the first frame (5.1); its components have no votes. Replaces what was there. The image is
  /// row-major, three bytes a pixel (b, g, r), without padding; an empty image leaves the mixture as it is.
  void start(std::span<const std::uint8_t> bgr, int width_px, int height_px);

  struct TrainingReport {
    int pixels = 0;    ///< of the event
    int left_out = 0;  ///< of those, beyond the gate of all and too few of a kind for a new component
    int new_components = 0;
    int replaced_components = 0;  ///< of the new ones, those that took the place of the least voted old one
    int updated_component = -1;   ///< index of the one that took most pixels; -1: none
  };
  /// One training event (5.1): all pixels of its patch, where it was seen from afar. Each goes to the
  /// component nearest in Mahalanobis distance (5.2), or to a new one if all are beyond the gate; after the
  /// last, means, covariances and votes are updated at once, so that only the making of new components
  /// depends on their order. No pixels, or label unknown: nothing happens.
  TrainingReport train(std::span<const std::array<std::uint8_t, 3>> bgr_pixels, TerrainClass label);

  /// At most params().max_components. A component keeps its index for life.
  const std::vector<MixtureComponent>& components() const { return components_; }
  const MixtureParams& params() const { return params_; }
  ColorSpace color_space() const { return color_space_; }

  /// Changes with every change of the components, and only then.
  std::uint64_t version() const { return version_; }

  /// Without textures, which are not the mixture's.
  MixtureSnapshot snapshot() const { return {color_space_, components_}; }
  /// Goes on from a saved mixture. Empty if taken over; else says why not (another colour space), and nothing
  /// changed.
  std::string restore(const MixtureSnapshot& saved);

 private:
  /// What one event's pixels say about one component.
  struct Evidence {
    double count_px = 0.0;
    Eigen::Vector3d offset_sum = Eigen::Vector3d::Zero();  ///< of colour minus mean
    Eigen::Matrix3d square_sum = Eigen::Matrix3d::Zero();  ///< of their outer products

    void add(const Eigen::Vector3d& offset);
  };
  /// A component that the present event may bring about.
  struct Newcomer {
    WhitenedGaussian whitened;
    Evidence evidence;
  };

  bool collect(const Eigen::Vector3d& color, bool may_begin);
  MixtureComponent first_shape(const Eigen::Vector3d& mean) const;
  MixtureComponent learn(MixtureComponent component, const Evidence& evidence, TerrainClass label,
                         double votes) const;
  std::size_t room(TrainingReport& report);
  void place(std::size_t index, const MixtureComponent& component);

  MixtureParams params_;
  ColorSpace color_space_;
  double scatter_kept_;  ///< share of a Gaussian's variance that is left of it inside the gate
  std::vector<MixtureComponent> components_;
  std::vector<WhitenedGaussian> whitened_;  ///< of components_, one for one
  std::vector<Evidence> evidence_;          ///< of the present event, one for one
  std::vector<Newcomer> newcomers_;         ///< of the present event
  std::vector<std::size_t> taken_;          ///< where this event's newcomers went
  std::uint64_t version_ = 0;
};

}  // namespace hindsight
