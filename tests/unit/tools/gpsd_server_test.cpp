// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/gpsd_server.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "config/exit_code.h"
#include "drivers/gpsd_client.h"
#include "tests/support/free_port.h"

namespace hindsight::tools {
namespace {

using std::chrono::milliseconds;

struct Fixes : SampleSink {
  std::vector<GpsFix> fixes;
  void on_fix(const GpsFix& fix) override { fixes.push_back(fix); }
  void on_frame(FrameRef) override {}
  void on_can(const CanFrame&) override {}
  void on_edge(const LineEdge&) override {}
  void on_report(const SourceReport&) override {}
};

TEST(GpsdServer, TheRobotsOwnClientHearsItsFixes) {
  GpsParams params;
  params.port = test::free_port();
  GpsdServer server(params);
  Fixes heard;
  GpsdClient client(params, heard);
  const std::vector<GpsFix> said{{.stamp = {},
                                  .latitude_deg = 37.4219,
                                  .longitude_deg = -122.17,
                                  .altitude_m = 60.0,
                                  .horizontal_sigma_m = 2.0}};
  for (int i = 0; i < 200 && heard.fixes.empty(); ++i) {
    server.serve(said);
    client.service(milliseconds(20));
  }
  ASSERT_FALSE(heard.fixes.empty());
  EXPECT_NEAR(heard.fixes[0].latitude_deg, 37.4219, 1e-9);
  EXPECT_NEAR(heard.fixes[0].longitude_deg, -122.17, 1e-9);
  EXPECT_NEAR(heard.fixes[0].altitude_m, 60.0, 1e-6);
  EXPECT_NEAR(heard.fixes[0].horizontal_sigma_m, 2.0, 1e-3);
}

TEST(GpsdServer, APortThatIsTakenIsNamed) {
  GpsParams params;
  params.port = test::free_port();
  const GpsdServer first(params);
  try {
    const GpsdServer second(params);
    FAIL() << "two servers on one port";
  } catch (const FatalError& error) {
    EXPECT_EQ(error.code(), kExitNoDevice);
    EXPECT_NE(std::string(error.what()).find(params.port), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace hindsight::tools
