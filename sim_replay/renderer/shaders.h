// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

namespace hindsight::shaders {

// GLSL, without its version line. Places are relative to the camera (W's axes, metres), light is linear.
extern const char* const ground_vertex;
extern const char* const ground_fragment;
extern const char* const object_vertex;
extern const char* const solid_fragment;
extern const char* const leaves_fragment;
extern const char* const screen_vertex;
extern const char* const sky_fragment;
extern const char* const sensor_fragment;

}  // namespace hindsight::shaders
