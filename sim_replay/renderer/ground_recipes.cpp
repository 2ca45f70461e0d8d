// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/ground_recipes.h"

namespace hindsight {
namespace {

using enum StampShape;

GroundRecipe grass() {
  return {albedo(62, 54, 40),
          albedo(96, 88, 62),
          0.015F,
          0.25F,
          {{blade,
            9000,
            0.05F,
            0.14F,
            16.0F,
            0.02F,
            {albedo(128, 116, 74), albedo(140, 128, 90), albedo(112, 104, 62)},
            0.45F},
           {blade,
            22000,
            0.04F,
            0.12F,
            14.0F,
            0.05F,
            {albedo(84, 104, 48), albedo(70, 94, 44), albedo(104, 116, 58), albedo(120, 122, 70)},
            0.45F},
           {leaf, 160, 0.02F, 0.05F, 1.8F, 0.05F, {albedo(124, 96, 62), albedo(96, 110, 60)}, 0.45F}}};
}

GroundRecipe leaf_litter() {
  return {albedo(52, 42, 32),
          albedo(92, 76, 58),
          0.02F,
          0.3F,
          {{leaf,
            5000,
            0.03F,
            0.09F,
            1.7F,
            0.03F,
            {albedo(128, 96, 66), albedo(150, 118, 86), albedo(108, 78, 54), albedo(92, 70, 52),
             albedo(160, 136, 108)},
            0.45F},
           {chip, 500, 0.04F, 0.2F, 18.0F, 0.03F, {albedo(92, 80, 66), albedo(120, 108, 92)}, 0.45F},
           {blade, 1500, 0.05F, 0.1F, 16.0F, 0.04F, {albedo(96, 108, 58)}, 0.45F}}};
}

GroundRecipe soil() {
  return {albedo(96, 80, 62),
          albedo(152, 130, 102),
          0.012F,
          0.35F,
          {{pebble,
            2500,
            0.004F,
            0.02F,
            1.3F,
            0.004F,
            {albedo(152, 137, 119), albedo(140, 126, 110), albedo(170, 158, 140)},
            0.25F},
           {chip, 150, 0.03F, 0.12F, 14.0F, 0.006F, {albedo(110, 92, 70)}, 0.45F},
           {leaf, 60, 0.02F, 0.05F, 1.8F, 0.01F, {albedo(120, 96, 64)}, 0.45F}}};
}

GroundRecipe mulch() {
  return {albedo(44, 24, 20),
          albedo(78, 42, 34),
          0.02F,
          0.3F,
          {{chip,
            9000,
            0.02F,
            0.08F,
            4.0F,
            0.03F,
            {albedo(112, 54, 44), albedo(96, 44, 36), albedo(132, 74, 58), albedo(78, 38, 32)},
            0.35F},
           {leaf, 120, 0.03F, 0.06F, 1.8F, 0.035F, {albedo(140, 112, 76)}, 0.45F}}};
}

GroundRecipe road() {
  return {albedo(116, 106, 92),
          albedo(158, 146, 128),
          0.006F,
          0.3F,
          {{pebble,
            12000,
            0.004F,
            0.018F,
            1.2F,
            0.002F,
            {albedo(148, 140, 126), albedo(124, 116, 104), albedo(172, 164, 150)},
            0.25F},
           {pebble, 200, 0.02F, 0.05F, 1.3F, 0.002F, {albedo(140, 130, 116), albedo(164, 156, 142)}, 0.2F}}};
}

GroundRecipe mud() {
  return {albedo(58, 48, 38),
          albedo(84, 70, 55),
          0.012F,
          0.15F,
          {{pebble, 400, 0.006F, 0.03F, 1.3F, 0.002F, {albedo(96, 84, 68)}, 0.2F}}};
}

GroundRecipe gravel() {
  return {albedo(120, 106, 84),
          albedo(168, 150, 122),
          0.012F,
          0.3F,
          {{pebble,
            14000,
            0.006F,
            0.03F,
            1.3F,
            0.006F,
            {albedo(150, 138, 118), albedo(128, 112, 92), albedo(172, 162, 144), albedo(140, 120, 96)},
            0.25F},
           {blade, 700, 0.05F, 0.15F, 18.0F, 0.03F, {albedo(150, 138, 98), albedo(126, 122, 78)}, 0.25F}}};
}

}  // namespace

GroundRecipe ground_recipe(Ground ground) {
  switch (ground) {
    case Ground::grass:
      return grass();
    case Ground::leaf_litter:
      return leaf_litter();
    case Ground::soil:
      return soil();
    case Ground::mulch:
      return mulch();
    case Ground::road:
      return road();
    case Ground::mud:
      return mud();
    case Ground::gravel:
      return gravel();
  }
  return soil();
}

}  // namespace hindsight
