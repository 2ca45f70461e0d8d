// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/world/obstacle.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hindsight {

std::vector<Obstacle> obstacles_of(const World& world) {
  std::vector<Obstacle> all;
  for (const Tree& tree : world.trees) {
    all.push_back({tree.at, tree.at, tree.radius_m, tree.height_m, TruthLabel::tree, false});
  }
  for (const Bush& bush : world.bushes) {
    all.push_back({bush.at, bush.at, bush.radius_m, bush.height_m, TruthLabel::bush, bush.drivable});
  }
  for (const Rock& rock : world.rocks) {
    all.push_back({rock.at, rock.at, rock.radius_m, rock.height_m, TruthLabel::rock, false});
  }
  for (const Fence& fence : world.fences) {
    for (std::size_t i = 1; i < fence.posts.size(); ++i) {
      all.push_back(
          {fence.posts[i - 1], fence.posts[i], kFenceRadius_m, fence.height_m, TruthLabel::fence, false});
    }
  }
  return all;
}

WorldPoint nearest_on_segment(WorldPoint a, WorldPoint b, WorldPoint p) {
  const double ux = b.x_m - a.x_m, uy = b.y_m - a.y_m;
  const double length2 = ux * ux + uy * uy;
  if (length2 == 0.0) return a;
  const double part = std::clamp(((p.x_m - a.x_m) * ux + (p.y_m - a.y_m) * uy) / length2, 0.0, 1.0);
  return {a.x_m + part * ux, a.y_m + part * uy};
}

double distance_m(const Obstacle& obstacle, WorldPoint p) {
  const WorldPoint nearest = nearest_on_segment(obstacle.a, obstacle.b, p);
  return std::hypot(p.x_m - nearest.x_m, p.y_m - nearest.y_m) - obstacle.radius_m;
}

const char* name_of(TruthLabel label) {
  constexpr std::array kNames{"sky", "ground", "tree", "bush", "fence", "road", "rock"};
  return kNames.at(static_cast<std::size_t>(label));
}

}  // namespace hindsight
