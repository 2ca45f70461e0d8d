// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What EvidenceGrid is held against.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "perception/evidence_grid.h"

namespace hindsight {

/// The same rules on a map without window or torus.
class NaiveGrid {
 public:
  struct Entry {
    std::array<double, 3> votes{}, frame{};
    double strength = 0;
    CellCost mark = CellCost::none, cost = CellCost::none;
  };
  explicit NaiveGrid(const EvidenceGridParams& params) : p_(params) {}

  void settle() {
    for (auto& [cell, e] : entries) {
      const double total = e.frame[0] + e.frame[1] + e.frame[2];
      if (total == 0) continue;
      const double factor = std::min(1.0, p_.max_frame_weight / total);
      add(e, factor * e.frame[0], factor * e.frame[1], factor * e.frame[2]);
      e.strength -= factor * e.frame[0];
      e.frame = {};
      judge(e);
    }
  }
  void mark(Entry& e, CellCost cost, double strength) {
    if (cost == CellCost::none) {
      e.strength -= strength;
      add(e, std::min(strength, p_.max_evidence), 0, 0);
    } else {
      e.mark = std::max(e.mark, cost);
      e.strength = std::max(e.strength, strength);
    }
    judge(e);
  }
  std::map<std::pair<int, int>, Entry> entries;

 private:
  void add(Entry& e, double good, double bad, double lethal) {
    const double before = e.votes[0] + e.votes[1] + e.votes[2];
    const double keep = std::min(1.0, (p_.max_evidence - good - bad - lethal) / std::max(before, 1e-9));
    e.votes = {keep * e.votes[0] + good, keep * e.votes[1] + bad, keep * e.votes[2] + lethal};
  }
  void judge(Entry& e) {
    const double total = e.votes[0] + e.votes[1] + e.votes[2];
    if (e.strength <= 0) e.mark = CellCost::none, e.strength = 0;
    const auto share = [&](CellCost level) { return e.cost >= level ? p_.leave_share : p_.enter_share; };
    CellCost cost = CellCost::none;
    if (total >= p_.min_evidence) {
      if (e.votes[1] + e.votes[2] > 0 && e.votes[1] + e.votes[2] >= total * share(CellCost::high))
        cost = CellCost::high;
      if (e.votes[2] > 0 && e.votes[2] >= total * share(CellCost::lethal)) cost = CellCost::lethal;
    }
    e.cost = std::max(cost, e.mark);
  }
  EvidenceGridParams p_;
};

}  // namespace hindsight
