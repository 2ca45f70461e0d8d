// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/vehicle/ground_contact.h"

#include <array>

namespace hindsight {

const GroundContact& contact_of(Ground ground) {
  static constexpr std::array<GroundContact, kGroundCount> kContacts{{
      {.friction = 0.55, .rolling = 0.06, .bumps_m = 0.008},                           // grass
      {.friction = 0.50, .rolling = 0.06, .bumps_m = 0.010},                           // leaf litter
      {.friction = 0.60, .rolling = 0.05, .bumps_m = 0.006},                           // soil
      {.friction = 0.50, .rolling = 0.07, .bumps_m = 0.008},                           // mulch
      {.friction = 0.85, .rolling = 0.02, .bumps_m = 0.002},                           // road
      {.friction = 0.14, .rolling = 0.04, .rolling_per_mps = 0.12, .bumps_m = 0.006},  // mud
      {.friction = 0.60, .rolling = 0.05, .bumps_m = 0.005},                           // gravel
  }};
  return kContacts.at(static_cast<std::size_t>(ground));
}

}  // namespace hindsight
