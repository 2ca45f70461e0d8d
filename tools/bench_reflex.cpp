// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/bench_reflex.h"

#include <fmt/format.h>
#include <linux/can.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>
#include <vector>

#include "config/exit_code.h"
#include "daemon/line_sink.h"
#include "daemon/live_reflex.h"
#include "daemon/run_setup.h"
#include "daemon/thread_setup.h"
#include "drivers/can_socket.h"
#include "drivers/monotonic_clock.h"
#include "tools/cpu_time.h"
#include "tools/simulated_lines.h"

namespace hindsight::tools {
namespace {

constexpr Time kServicePeriod = from_seconds(0.05);  // as the daemon's
constexpr Time kLongestWait = from_seconds(2.0);
constexpr unsigned kSeed = 20110501;

struct ReflexBenchOptions {
  std::vector<std::string> configuration_files;
  int touches = 2000;
  int load = 0;
  bool json = false;
};

/// Threads that keep the processors busy.
class BusyThreads {
 public:
  explicit BusyThreads(int count) {
    for (int i = 0; i < count; ++i) {
      threads_.emplace_back([this] {
        while (!ending_.load(std::memory_order_relaxed)) {
        }
      });
    }
  }
  ~BusyThreads() {
    ending_ = true;
    for (std::thread& thread : threads_) thread.join();
  }

 private:
  std::atomic<bool> ending_{false};
  std::vector<std::thread> threads_;
};

/// The daemon's way from the lines to the bus; the loop's place is taken by drive().
class ReflexPath {
 public:
  ReflexPath(const Configuration& configuration, const Dbc& dbc)
      : reflex_(configuration, dbc, board_, heartbeats_),
        sink_(board_, reflex_),
        lines_(configuration.gpio, sink_),
        stop_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
        thread_([this, priority = configuration.reflex.realtime_priority] {
          make_this_thread_realtime(priority);
          while (!ending_.load(std::memory_order_relaxed)) {
            lines_.service(kServicePeriod, stop_.get());
            sink_.looked(monotonic_now());
          }
        }) {
    board_.bus_ok = true;
  }
  ~ReflexPath() {
    ending_ = true;
    const std::uint64_t one = 1;
    static_cast<void>(!write(stop_.get(), &one, sizeof one));
    thread_.join();
  }

  /// What the loop says in each tick: go on.
  void drive() { board_.decision.write({{0.5, 0.5}, monotonic_now(), StopReason::none}); }
  /// When the bumper was last pressed, by the kernel's stamp.
  Time last_edge() const { return Time(board_.last_bumper_edge_ns.load()); }

 private:
  ReflexBoard board_;
  Heartbeats heartbeats_;
  LiveReflex reflex_;
  LineSink sink_;
  GpioLines lines_;
  UniqueFd stop_;
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

/// The vehicle's base, as far as it listens.
class Listener {
 public:
  Listener(const Configuration& configuration, const Dbc& dbc) : codec_(dbc, configuration.can_roles) {
    const std::array<std::uint32_t, 1> ids{codec_.id()};
    DeviceError error;
    socket_ = open_can_receiver(configuration.can.interface, ids, error);
    if (!socket_) throw FatalError(kExitNoDevice, error.message);
  }

  /// Waits for a set-point that permits motion, or forbids it; returns when it was received.
  Time wait_for(bool permitted, const std::function<void()>& meanwhile) {
    const Time end = monotonic_now() + kLongestWait;
    while (monotonic_now() < end) {
      pollfd fd{socket_.get(), POLLIN, 0};
      poll(&fd, 1, 20);
      can_frame raw{};
      while (read(socket_.get(), &raw, sizeof raw) == static_cast<ssize_t>(sizeof raw)) {
        if (permits(raw) == permitted) return monotonic_now();
      }
      meanwhile();
    }
    throw FatalError(kExitSoftware, permitted ? "no set-point permits motion" : "no zero follows a touch");
  }

 private:
  bool permits(const can_frame& raw) const {
    CanFrame frame{.id = raw.can_id, .length = raw.can_dlc};
    std::copy_n(raw.data, frame.data.size(), frame.data.begin());
    WheelSetpoints set_points;
    std::uint32_t counter = 0;
    return codec_.decode(frame, set_points, counter) && set_points.enable;
  }

  DriveCommandCodec codec_;
  UniqueFd socket_;
};

struct Latencies {
  std::vector<double> from_pull_us;  ///< from just before the line is pulled
  std::vector<double> from_edge_us;  ///< from the kernel's time stamp of the edge: the daemon's share
};

void touch(SimulatedLines& lines, ReflexPath& path, Listener& listener, Time pause, Latencies& latencies) {
  const auto go_on = [&] { path.drive(); };
  go_on();
  listener.wait_for(true, go_on);
  std::this_thread::sleep_for(pause);
  go_on();
  const Time began = monotonic_now();
  lines.pull({began, Line::bumper_left, true});
  const Time stopped = listener.wait_for(false, [] {});
  latencies.from_pull_us.push_back(1e6 * to_seconds(stopped - began));
  latencies.from_edge_us.push_back(1e6 * to_seconds(stopped - path.last_edge()));
  lines.pull({stopped, Line::bumper_left, false});
}

Latencies measure(const ReflexBenchOptions& options) {
  const Configuration configuration = load_configuration(options.configuration_files);
  const RobotSetup setup = make_setup(configuration, load_materials(configuration), "");
  SimulatedLines lines(configuration.gpio);
  Listener listener(configuration, setup.dbc);
  ReflexPath path(configuration, setup.dbc);
  const BusyThreads load(options.load);
  make_this_thread_realtime(configuration.reflex.realtime_priority);  // it must not be what is measured
  std::mt19937 random(kSeed);
  std::uniform_int_distribution<int> pause_us(0, 10000);  // at every phase of the reflex's period
  Latencies latencies;
  for (int i = 0; i < options.touches; ++i)
    touch(lines, path, listener, std::chrono::microseconds(pause_us(random)), latencies);
  return latencies;
}

nlohmann::ordered_json summary(const std::vector<double>& us) {
  return {{"median", quantile(us, 0.5)},
          {"99 %", quantile(us, 0.99)},
          {"99.9 %", quantile(us, 0.999)},
          {"maximum", quantile(us, 1.0)}};
}

int bench_reflex(const ReflexBenchOptions& options) {
  const Latencies latencies = measure(options);
  const nlohmann::ordered_json result = {{"touches", options.touches},
                                         {"load_threads", options.load},
                                         {"from_pull_us", summary(latencies.from_pull_us)},
                                         {"from_edge_us", summary(latencies.from_edge_us)}};
  if (options.json) {
    fmt::print("{}\n", result.dump(2));
    return kExitOk;
  }
  const nlohmann::ordered_json flat = result.flatten();
  for (const auto& [key, value] : flat.items())
    fmt::print("{:<24} {:>10.0f}\n", key.substr(1), value.get<double>());
  return kExitOk;
}

}  // namespace

void add_bench_reflex(CLI::App& bench, Run& run) {
  auto options = std::make_shared<ReflexBenchOptions>();
  CLI::App* command = bench.add_subcommand(
      "reflex", "Time a bumper's edge until zero is on the CAN bus; needs simulated GPIO lines (gpio-sim)");
  command->add_option("--config", options->configuration_files, "Configuration file, as hindsightd's")
      ->required()
      ->type_name("FILE");
  command->add_option("--touches", options->touches, "How often the bumper is pulled")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command->add_option("--load", options->load, "Threads that keep the processors busy meanwhile")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options, &run] { run = [options] { return bench_reflex(*options); }; });
}

}  // namespace hindsight::tools
