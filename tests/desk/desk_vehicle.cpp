// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The vehicle's base at the other end of the CAN bus: follows drive commands as wheels do, stops without them
// as config/lagr.dbc says, and sends encoders, currents, ranges, battery and yaw rate at their rates. Writes
// each good command that it received to a CSV file.
#include <linux/can.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "config/vehicle_params.h"
#include "drivers/dbc.h"
#include "drivers/drive_command_codec.h"
#include "drivers/monotonic_clock.h"
#include "drivers/vehicle_base_codec.h"

namespace {

using namespace hindsight;
using namespace std::chrono_literals;

constexpr Time kStep = 10ms;
constexpr Time kCommandTimeout = 100ms;  // config/lagr.dbc, DRIVE_COMMAND
constexpr double kTicksPerMetre = 1000.0;
constexpr double kTickWrap = 4096.0;
constexpr double kNothingInRange_m = 4.095;

int open_bus(const std::string& interface) {
  const int bus = socket(PF_CAN, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, CAN_RAW);
  ifreq request{};
  std::strncpy(request.ifr_name, interface.c_str(), IFNAMSIZ - 1);
  sockaddr_can address{};
  address.can_family = AF_CAN;
  if (bus < 0 || ioctl(bus, SIOCGIFINDEX, &request) != 0 ||
      (address.can_ifindex = request.ifr_ifindex,
       bind(bus, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0)) {
    throw std::system_error(errno, std::generic_category(), interface);
  }
  return bus;
}

/// Wheels behind motor controllers: they reach the set-point with limited acceleration.
class Wheels {
 public:
  void command(const WheelSetpoints& set_point, Time now) {
    set_point_ = set_point;
    commanded_at_ = now;
  }

  void step(Time now, double dt_s) {
    const bool driven = set_point_.enable && now - commanded_at_ < kCommandTimeout;
    const double step_mps = VehicleParams{}.max_acceleration_mps2 * dt_s;
    roll(signals_.left_mps, signals_.left_ticks, driven ? set_point_.left_mps : 0.0, step_mps, dt_s);
    roll(signals_.right_mps, signals_.right_ticks, driven ? set_point_.right_mps : 0.0, step_mps, dt_s);
    signals_.left_a = current_a(signals_.left_mps, to_seconds(now));
    signals_.right_a = current_a(signals_.right_mps, to_seconds(now) + 0.4);
    signals_.ir_left_m = signals_.ir_right_m = kNothingInRange_m;
    signals_.battery_v = 24.6;
    signals_.yaw_rate_radps = (signals_.right_mps - signals_.left_mps) / VehicleParams{}.track_width_m;
  }

  const VehicleSignals& signals() const { return signals_; }

 private:
  static void roll(double& speed_mps, double& ticks, double wanted_mps, double step_mps, double dt_s) {
    speed_mps += std::clamp(wanted_mps - speed_mps, -step_mps, step_mps);
    ticks = std::fmod(ticks + speed_mps * dt_s * kTicksPerMetre + kTickWrap, kTickWrap);
  }
  // Rolling resistance and the commutator's ripple, far above the 3 Hz of slipping wheels.
  static double current_a(double speed_mps, double t_s) {
    return 1.0 + 6.0 * std::abs(speed_mps) + 0.2 * std::sin(2.0 * M_PI * 17.0 * t_s);
  }

  WheelSetpoints set_point_;
  Time commanded_at_{};
  VehicleSignals signals_;
};

void receive(int bus, const DriveCommandCodec& codec, Wheels& wheels, std::FILE* csv) {
  can_frame raw{};
  while (read(bus, &raw, sizeof raw) == static_cast<ssize_t>(sizeof raw)) {
    CanFrame frame{.stamp = monotonic_now(), .id = raw.can_id, .length = raw.can_dlc};
    std::copy_n(raw.data, frame.data.size(), frame.data.begin());
    WheelSetpoints command;
    std::uint32_t counter = 0;
    if (!codec.decode(frame, command, counter)) continue;
    wheels.command(command, frame.stamp);
    std::fprintf(csv, "%.3f,%.3f,%.3f,%d,%u\n", to_seconds(frame.stamp), command.left_mps, command.right_mps,
                 command.enable ? 1 : 0, counter);
  }
}

void send(int bus, const std::vector<CanFrame>& frames) {
  for (const CanFrame& frame : frames) {
    can_frame raw{};
    raw.can_id = frame.id;
    raw.can_dlc = frame.length;
    std::copy_n(frame.data.begin(), frame.data.size(), raw.data);
    // A full queue loses the frame, as a busy bus does.
    if (write(bus, &raw, sizeof raw) < 0 && errno != ENOBUFS && errno != EAGAIN && errno != ENETDOWN) {
      throw std::system_error(errno, std::generic_category(), "sending a frame");
    }
  }
}

void run(int bus, const Dbc& dbc, std::FILE* csv) {
  const CanRolesParams roles;
  const DriveCommandCodec commands(dbc, roles);
  VehicleBaseCodec codec(dbc, roles);
  Wheels wheels;
  std::vector<CanFrame> frames;
  Time due = monotonic_now();
  for (unsigned step = 0;; ++step) {
    for (Time now = monotonic_now(); now < due; now = monotonic_now()) {
      pollfd wait{.fd = bus, .events = POLLIN, .revents = 0};
      poll(&wait, 1, static_cast<int>((due - now) / 1ms) + 1);
      receive(bus, commands, wheels, csv);
    }
    wheels.step(due, to_seconds(kStep));
    frames.clear();
    const auto every = [&](unsigned steps, SignalGroup group) {
      if (step % steps == 0) codec.encode(group, wheels.signals(), due, frames);
    };
    every(1, SignalGroup::imu);
    every(2, SignalGroup::wheels);  // the ticks go in the same frame
    every(2, SignalGroup::currents);
    every(5, SignalGroup::ir_ranges);
    every(100, SignalGroup::battery);
    send(bus, frames);
    due += kStep;
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::string interface = "vcan0";
  std::string dbc;
  std::string csv_path;
  CLI::App app{"Stands in for the vehicle's base on a CAN bus until it is killed."};
  app.add_option("--interface", interface, "CAN interface");
  app.add_option("--dbc", dbc, "the protocol")->required();
  app.add_option("--csv", csv_path, "writes the received commands here")->required();
  CLI11_PARSE(app, argc, argv);
  try {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> csv(std::fopen(csv_path.c_str(), "w"), std::fclose);
    if (!csv) throw std::system_error(errno, std::generic_category(), csv_path);
    setvbuf(csv.get(), nullptr, _IOLBF, BUFSIZ);  // the drive's script reads it meanwhile
    std::fprintf(csv.get(), "monotonic_s,left_mps,right_mps,enable,counter\n");
    run(open_bus(interface), read_dbc(dbc), csv.get());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "desk_vehicle: %s\n", error.what());
    return 1;
  }
}
