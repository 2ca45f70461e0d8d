// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "daemon/command_receiver.h"
#include "daemon/heartbeats.h"
#include "daemon/line_sink.h"
#include "daemon/live_reflex.h"
#include "daemon/robot_config.h"
#include "daemon/sample_queue.h"
#include "drivers/dbc.h"
#include "drivers/frame_pool.h"
#include "drivers/unique_fd.h"

namespace hindsight {

/// The hardware: every driver on a thread of its own, each with a queue to the loop.
class LiveSources {
 public:
  /// Opens every device. FatalError(kExitNoDevice) for one that is absent or busy, before any thread runs.
  LiveSources(const Configuration& configuration, const Dbc& dbc, ReflexBoard& board, LiveReflex& reflex,
              Heartbeats& heartbeats);
  ~LiveSources();

  /// Called by the loop: all samples that have come.
  void drain_into(TickInput& input);

 private:
  class BusSink : public SampleQueue {
   public:
    explicit BusSink(ReflexBoard& board) : board_(board) {}
    void on_report(const SourceReport& report) override;

   private:
    ReflexBoard& board_;
  };

  /// A thread that calls `service` again and again and beats after each. `priority`: of SCHED_FIFO, 0: none.
  void serve(ThreadId id, int priority, std::function<void()> service);

  Heartbeats& heartbeats_;
  UniqueFd stop_;
  std::atomic<bool> stopping_{false};
  FramePool pool_;
  SampleQueue frames_;
  BusSink bus_;
  LineSink lines_;
  SampleQueue fixes_;
  SampleQueue commands_;
  std::unique_ptr<V4l2Camera> camera_;
  std::unique_ptr<SocketCanBus> can_;
  std::unique_ptr<GpioLines> gpio_;
  std::unique_ptr<GpsdClient> gps_;
  std::unique_ptr<CommandReceiver> receiver_;
  std::vector<std::thread> threads_;
};

}  // namespace hindsight
