// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The client against a real gpsd, which gpsfake feeds with sentences of a known place, on loopback.
#include "drivers/gpsd_client.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>

#include "drivers/monotonic_clock.h"
#include "recording_sink.h"
#include "tests/support/free_port.h"

namespace hindsight {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

std::string sentence(const std::string& body) {
  unsigned checksum = 0;
  for (const char c : body) checksum ^= static_cast<unsigned char>(c);
  return fmt::format("${}*{:02X}\r\n", body, checksum);
}

/// One second of a receiver at 47.205760 N, 8.525000 E, 450 m above the sea, 498 m above the ellipsoid.
std::string epoch(int second, bool has_fix) {
  const std::string time = fmt::format("12{:02}{:02}.00", second / 60, second % 60);
  if (!has_fix)
    return sentence("GPRMC," + time + ",V,,,,,,,211126,,,N") +
           sentence("GPGGA," + time + ",,,,,0,00,99.9,,,,,,");
  return sentence("GPRMC," + time + ",A,4712.34560,N,00831.50000,E,0.1,0.0,211126,,,A") +
         sentence("GPGGA," + time + ",4712.34560,N,00831.50000,E,1,08,1.0,450.0,M,48.0,M,,") +
         sentence("GPGSA,A,3,04,05,09,12,17,20,24,28,,,,,1.8,1.0,1.5") +
         sentence("GPGST," + time + ",5.0,3.0,2.0,0.0,3.0,2.0,4.0");
}

/// gpsfake and the gpsd that it starts, in a process group of their own.
class FakeGpsd {
 public:
  FakeGpsd(const std::string& port, const std::string& log) : child_(::fork()) {
    if (child_ != 0) return;
    ::setpgid(0, 0);
    const std::string quiet = fmt::format("exec gpsfake -q -c 0.005 -P {} '{}' > /dev/null 2>&1", port, log);
    ::execl("/bin/sh", "sh", "-c", quiet.c_str(), nullptr);
    ::_exit(127);
  }
  ~FakeGpsd() {
    ::kill(-child_, SIGKILL);
    ::waitpid(child_, nullptr, 0);
  }
  FakeGpsd(const FakeGpsd&) = delete;
  FakeGpsd& operator=(const FakeGpsd&) = delete;

 private:
  pid_t child_;
};

class Gpsd : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v gpsfake > /dev/null && command -v gpsd > /dev/null") != 0) {
      GTEST_SKIP() << "gpsd and gpsfake are not installed";
    }
    log_ = std::filesystem::temp_directory_path() / fmt::format("gpsd_client_test_{}.nmea", ::getpid());
    std::ofstream file(log_);
    for (int second = 0; second < 120; ++second) file << epoch(second, second >= 10);
  }
  void TearDown() override { std::filesystem::remove(log_); }

  bool serve(GpsdClient& client, std::function<bool()> done) {
    const Time end = monotonic_now() + seconds(20);
    while (!done() && monotonic_now() < end) client.service(milliseconds(50));
    return done();
  }
  std::filesystem::path log_;
  RecordingSink sink_;
};

TEST_F(Gpsd, GivesFixesLosesItAndFindsItAgain) {
  GpsParams params;
  params.port = test::free_port();
  params.reopen.longest_s = 0.5;
  GpsdClient client(params, sink_);
  {
    const FakeGpsd gpsd(params.port, log_);
    ASSERT_TRUE(serve(client, [&] { return sink_.fixes.size() >= 5; }));
  }
  for (const GpsFix& fix : sink_.fixes) {
    EXPECT_NEAR(fix.latitude_deg, 47.205760, 1e-6);
    EXPECT_NEAR(fix.longitude_deg, 8.525, 1e-6);
    EXPECT_LE(fix.stamp, monotonic_now());
  }
  EXPECT_NEAR(sink_.fixes.back().altitude_m, 498.0, 0.5);
  EXPECT_GT(sink_.fixes.back().horizontal_sigma_m, 0.5);
  EXPECT_LT(sink_.fixes.back().horizontal_sigma_m, 20.0);
  EXPECT_TRUE(sink_.last_state_is(SourceState::fresh));
  ASSERT_TRUE(serve(client, [&] { return sink_.last_state_is(SourceState::failed); }));
  const FakeGpsd again(params.port, log_);
  EXPECT_TRUE(serve(client, [&] { return sink_.last_state_is(SourceState::fresh); }));
}

}  // namespace
}  // namespace hindsight
