// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// check_log RUN.lcm: what the recorded log of the live drive must hold, read with LCM's own reader and
// generated types.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <lcm/lcm-cpp.hpp>
#include <string>

#include "hindsight/state_t.hpp"
#include "hindsight/training_t.hpp"

namespace {

constexpr int kBumperLeft = 0;  // training_t.cause and index of state_t.line_active
constexpr int kBackUp = 4;      // state_t.behaviour
constexpr int kLethal = 2;      // training_t.label

/// What was seen, in the order of the checks.
struct Seen {
  int states = 0;
  bool armed = false;
  bool drove = false;    // set-points forward on the bus
  bool bumper = false;   // the line was seen pressed
  bool stopped = false;  // zero or reverse set-points on the bus while it was
  bool traced = false;   // a lethal lesson from the left bumper, traced back by some frames
  int furthest_back = 0;
  int trained_pixels = 0;
  bool backed_up = false;
};

template <class Message>
bool decode(const lcm::LogEvent& event, Message& message) {
  return message.decode(event.data, 0, event.datalen) >= 0;
}

void take(const hindsight::state_t& state, Seen& seen) {
  ++seen.states;
  seen.armed |= state.armed != 0;
  seen.drove |= state.reflex_mps[0] > 0.05F && state.reflex_mps[1] > 0.05F;
  const bool pressed = state.line_active[kBumperLeft] != 0;
  seen.bumper |= pressed;
  seen.stopped |= pressed && state.reflex_mps[0] <= 0.0F && state.reflex_mps[1] <= 0.0F;
  seen.backed_up |= state.behaviour == kBackUp && state.reflex_mps[0] < 0.0F && state.reflex_mps[1] < 0.0F;
}

void take(const hindsight::training_t& lesson, Seen& seen) {
  if (lesson.cause != kBumperLeft || lesson.label != kLethal || lesson.in_view == 0) return;
  seen.furthest_back = std::max(seen.furthest_back, lesson.to_frames_back);
  seen.traced |= seen.furthest_back > 0;
  seen.trained_pixels += lesson.pixels;
}

Seen read(lcm::LogFile& log) {
  Seen seen;
  hindsight::state_t state;
  hindsight::training_t lesson;
  while (const lcm::LogEvent* event = log.readNextEvent()) {
    if (event->channel == "HINDSIGHT_STATE" && decode(*event, state)) take(state, seen);
    if (event->channel == "HINDSIGHT_TRAINING" && decode(*event, lesson)) take(lesson, seen);
  }
  return seen;
}

int check(bool good, const char* what) {
  std::printf("%s: %s\n", good ? "ok" : "FAILED", what);
  return good ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 64;
  lcm::LogFile log(argv[1], "r");
  if (!log.good()) {
    std::fprintf(stderr, "check_log: cannot read %s\n", argv[1]);
    return 66;
  }
  const Seen seen = read(log);
  int failures = 0;
  failures += check(seen.states > 50, "the log holds the state of more than 50 ticks");
  failures += check(seen.armed, "the daemon was armed");
  failures += check(seen.drove, "it drove");
  failures += check(seen.bumper, "it saw the left bumper");
  failures += check(seen.stopped, "while it was pressed, zero or reverse set-points went to the bus");
  failures += check(seen.traced, "it traced the touched patch back to earlier frames");
  failures += check(seen.trained_pixels > 0, "it trained the mixture with what it found there");
  failures += check(seen.backed_up, "it backed up");
  std::printf("%d ticks; traced back by up to %d frames; trained with %d pixels\n", seen.states,
              seen.furthest_back, seen.trained_pixels);
  return failures > 0 ? 1 : 0;
}
