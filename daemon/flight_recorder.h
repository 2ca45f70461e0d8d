// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The last seconds before a fault. Always on: every tick is encoded as the run log would hold it and kept in
// a ring of fixed size; when a fault stops the vehicle, the ring becomes a run log of its own.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>

#include "config/params.h"
#include "daemon/fault_trigger.h"
#include "daemon/tick_record.h"
#include "daemon/tick_ring.h"
#include "drivers/frame_pool.h"
#include "sim_replay/event_block.h"
#include "sim_replay/run_header.h"
#include "sim_replay/run_log_encoder.h"

namespace hindsight {

struct FlightRecorderParams {
  std::string folder;
  double seconds = 30.0;
  int memory_mb = 16;
  int jpeg_quality = 60;
  int files = 10;

  void visit(auto&& param) {
    param("folder", folder, AnyText{},
          "where the last seconds before a fault are written; empty: the recorder is off");
    param("seconds", seconds, Range{1.0, 600.0},
          "how far back it remembers, if the memory is large enough [s]");
    param("memory_mb", memory_mb, Range{1, 4096}, "memory for what it remembers [MiB]");
    param("jpeg_quality", jpeg_quality, Range{10, 95},
          "of pictures that the camera does not compress itself");
    param("files", files, Range{1, 10000}, "how many files are kept; the oldest go");
  }
};

/// One thread takes the ticks and looks after what is due; request() may come from any.
class FlightRecorder {
 public:
  /// `header` is that of the run; so is its mixture, since the one at the ring's first tick is not known. A
  /// folder that cannot be made is told, and again whenever a file cannot be written.
  FlightRecorder(const FlightRecorderParams& params, RunHeader header);
  /// Writes what is still due.
  ~FlightRecorder();

  void take(const TickRecord& record);
  /// Call often, also while no tick comes: writes the ring a second after a fault, so that its consequences
  /// are in it.
  void look_after(Time now);
  /// Write now, without a tick that tells the fault: a thread is lost.
  void request(StopReason fault) { requested_.store(fault); }
  /// Whether nothing waits to be written.
  bool idle() const { return requested_.load() == StopReason::none; }

 private:
  class Compressor;

  void remember(const TickRecord& record);
  void compress_picture();
  void write(StopReason fault);
  std::filesystem::path new_file(StopReason fault) const;
  void remove_oldest() const;

  FlightRecorderParams params_;
  RunHeader header_;
  FaultTrigger trigger_;
  TickRing ring_;
  EventBlock block_;
  RunLogEncoder encoder_;
  std::unique_ptr<Compressor> compressor_;
  FramePool pictures_;
  TickInput input_;
  std::atomic<StopReason> requested_{StopReason::none};
  StopReason due_fault_ = StopReason::none;
  Time due_{};
};

}  // namespace hindsight
