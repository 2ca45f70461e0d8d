// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "config/configuration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <random>

#include "config/exit_code.h"
#include "config/vehicle_params.h"

namespace hindsight {
namespace {

struct TrackerParams {
  int window_px = 9;
  double quality = 0.01;
  bool smooth = true;
  std::string fill = "neighbours";
  void visit(auto&& param) {
    param("window_px", window_px, Range{3, 31}, "side of the tracking window [px]");
    param("quality", quality, Range{0.0, 1.0}, "least eigenvalue over the best");
    param("smooth", smooth, YesNo{}, "smooth first");
    param("fill", fill, Choices{"zero", "neighbours"}, "what an empty cell holds");
  }
};

struct FlowParams {
  double gain = 1.0;
  std::string device = "/dev/video0";
  std::vector<double> weights = {0.25, 0.5};
  std::vector<std::string> names = {"left"};
  std::vector<std::string> order;
  void visit(auto&& param) {
    param("gain", gain, Range{}, "gain");
    param("device", device, AnyText{}, "camera");
    param("weights", weights, Range{.min = 0.0}, "weights");
    param("names", names, AnyText{}, "names");
    param("order", order, Choices{"a", "b"}, "order");
  }
};

struct Configuration {
  TrackerParams tracker;
  FlowParams flow;
  VehicleParams vehicle;
  void visit(auto&& section) {
    section("tracker", tracker);
    section("perception.flow", flow);
    section("vehicle", vehicle);
  }
};

Configuration read(std::string_view text) {
  Configuration configuration;
  read_configuration(configuration, ConfigDocument::parse(text, "lagr.toml"));
  return configuration;
}

std::string error_of(std::string_view text) {
  try {
    read(text);
  } catch (const FatalError& error) {
    EXPECT_EQ(error.code(), kExitConfiguration);
    return error.what();
  }
  return "no error";
}

TEST(ReadConfiguration, SetsWhatIsNamedAndKeepsTheRest) {
  const Configuration c = read(
      "[tracker]\nwindow_px = 11\nsmooth = false\nfill = 'zero'\n"
      "[perception.flow]\ngain = -2.5\ndevice = \"/dev/video1\"\nweights = [1, 2.5]\nnames = []\norder = "
      "['b', 'a']\n");
  EXPECT_EQ(c.tracker.window_px, 11);
  EXPECT_FALSE(c.tracker.smooth);
  EXPECT_EQ(c.tracker.fill, "zero");
  EXPECT_EQ(c.tracker.quality, 0.01);
  EXPECT_EQ(c.flow.gain, -2.5);
  EXPECT_EQ(c.flow.device, "/dev/video1");
  EXPECT_THAT(c.flow.weights, testing::ElementsAre(1.0, 2.5));
  EXPECT_THAT(c.flow.names, testing::IsEmpty());
  EXPECT_THAT(c.flow.order, testing::ElementsAre("b", "a"));
}

TEST(ReadConfiguration, TakesAnIntegerForADouble) {
  EXPECT_EQ(read("[tracker]\nquality = 1").tracker.quality, 1.0);
}

TEST(ReadConfiguration, TakesTheBoundsOfARange) {
  EXPECT_EQ(read("[tracker]\nwindow_px = 3").tracker.window_px, 3);
  EXPECT_EQ(read("[tracker]\nwindow_px = 31").tracker.window_px, 31);
}

TEST(ReadConfiguration, TakesNestedSectionsInAnySpelling) {
  EXPECT_EQ(read("[perception]\n[perception.flow]\ngain = 3").flow.gain, 3.0);
  EXPECT_EQ(read("[perception]\nflow.gain = 3").flow.gain, 3.0);
  EXPECT_EQ(read("perception.flow.gain = 3").flow.gain, 3.0);
}

TEST(ReadConfiguration, LaterDocumentsOverrideEarlierOnes) {
  Configuration c;
  read_configuration(c, ConfigDocument::parse("[tracker]\nwindow_px = 5\nquality = 0.5", "lagr.toml"));
  read_configuration(c, ConfigDocument::parse("[tracker]\nwindow_px = 7", "thesis.toml"));
  EXPECT_EQ(c.tracker.window_px, 7);
  EXPECT_EQ(c.tracker.quality, 0.5);
}

TEST(ReadConfiguration, LeavesEverythingAsItWasOnAnError) {
  Configuration c;
  EXPECT_THROW(
      read_configuration(c, ConfigDocument::parse("[tracker]\nwindow_px = 5\nquality = 2", "lagr.toml")),
      FatalError);
  EXPECT_EQ(c.tracker.window_px, 9);
}

struct BadCase {
  const char* name;
  const char* text;
  const char* message;
};
void PrintTo(const BadCase& bad, std::ostream* out) { *out << bad.name; }

class BadConfiguration : public testing::TestWithParam<BadCase> {};

TEST_P(BadConfiguration, IsNamedExactly) { EXPECT_EQ(error_of(GetParam().text), GetParam().message); }

INSTANTIATE_TEST_SUITE_P(
    Errors, BadConfiguration,
    testing::Values(
        BadCase{"unknown_section", "[trakcer]\nwindow_px = 3",
                "lagr.toml:1:2: unknown section [trakcer]; the nearest is [tracker]"},
        BadCase{"unknown_nested_section", "[perception.flaw]",
                "lagr.toml:1:13: unknown section [perception.flaw]; the nearest is [perception.flow]"},
        BadCase{"quoted_dot", "['perception.flow']",
                "lagr.toml:1:2: unknown section [\"perception.flow\"]; the nearest is [perception.flow]"},
        BadCase{"unknown_key", "[tracker]\nwidow_px = 3",
                "lagr.toml:2:1: [tracker] widow_px = 3: unknown key; the nearest is \"window_px\""},
        BadCase{"key_in_parent_section", "[perception]\ngain = 3",
                "lagr.toml:2:1: [perception] gain = 3: unknown key"},
        BadCase{"key_without_section", "window_px = 3",
                "lagr.toml:1:1: window_px = 3: expected every key inside a [section]"},
        BadCase{"value_for_section", "tracker = 3",
                "lagr.toml:1:1: tracker = 3: expected a section, [tracker]"},
        BadCase{"list_of_sections", "[[tracker]]\nwindow_px = 3",
                "lagr.toml:1:3: tracker = [ { window_px = 3 } ]: expected a section, [tracker]"},
        BadCase{"section_for_key", "[tracker.window_px]",
                "lagr.toml:1:10: unknown section [tracker.window_px]; the nearest is [tracker]"},
        BadCase{"double_for_int", "[tracker]\nwindow_px = 9.5",
                "lagr.toml:2:13: [tracker] window_px = 9.5: expected an integer, 3 to 31"},
        BadCase{"string_for_int", "[tracker]\nwindow_px = '9'",
                "lagr.toml:2:13: [tracker] window_px = '9': expected an integer, 3 to 31"},
        BadCase{"int_too_wide", "[tracker]\nwindow_px = 4294967305",
                "lagr.toml:2:13: [tracker] window_px = 4294967305: expected an integer, 3 to 31"},
        BadCase{"int_out_of_range", "[tracker]\nwindow_px = 33",
                "lagr.toml:2:13: [tracker] window_px = 33: expected an integer, 3 to 31"},
        BadCase{"bool_for_double", "[tracker]\nquality = true",
                "lagr.toml:2:11: [tracker] quality = true: expected a number, 0 to 1"},
        BadCase{"double_out_of_range", "[tracker]\nquality = 1.5",
                "lagr.toml:2:11: [tracker] quality = 1.5: expected a number, 0 to 1"},
        BadCase{"nan", "[tracker]\nquality = nan",
                "lagr.toml:2:11: [tracker] quality = nan: expected a number, 0 to 1"},
        BadCase{"int_for_bool", "[tracker]\nsmooth = 1",
                "lagr.toml:2:10: [tracker] smooth = 1: expected true or false"},
        BadCase{"not_a_choice", "[tracker]\nfill = 'mean'",
                "lagr.toml:2:8: [tracker] fill = 'mean': expected a string, one of \"zero\", \"neighbours\""},
        BadCase{"int_for_string", "[perception.flow]\ndevice = 0",
                "lagr.toml:2:10: [perception.flow] device = 0: expected a string"},
        BadCase{"date_for_string", "[perception.flow]\ndevice = 2026-01-02",
                "lagr.toml:2:10: [perception.flow] device = 2026-01-02: expected a string"},
        BadCase{
            "scalar_for_list", "[perception.flow]\nweights = 1.0",
            "lagr.toml:2:11: [perception.flow] weights = 1.0: expected a list of numbers, each at least 0"},
        BadCase{"element_out_of_range", "[perception.flow]\nweights = [1, -1]",
                "lagr.toml:2:11: [perception.flow] weights = [ 1, -1 ]: expected a list of numbers, each at "
                "least 0"},
        BadCase{"element_of_wrong_type", "[perception.flow]\nnames = ['a', 1]",
                "lagr.toml:2:9: [perception.flow] names = [ 'a', 1 ]: expected a list of strings"},
        BadCase{"element_not_a_choice", "[perception.flow]\norder = ['c']",
                "lagr.toml:2:9: [perception.flow] order = [ 'c' ]: expected a list of strings, each one of "
                "\"a\", "
                "\"b\""},
        BadCase{
            "twice", "[tracker]\nwindow_px = 5\nwindow_px = 7",
            "lagr.toml:3:13: not TOML: Error while parsing key-value pair: cannot redefine existing integer "
            "'window_px'"},
        BadCase{"several", "[tracker]\nfill = 'mean'\nwindow_px = 5\nsmoth = true\n[vehicel]",
                "lagr.toml:2:8: [tracker] fill = 'mean': expected a string, one of \"zero\", \"neighbours\"\n"
                "lagr.toml:4:1: [tracker] smoth = true: unknown key; the nearest is \"smooth\"\n"
                "lagr.toml:5:2: unknown section [vehicel]; the nearest is [vehicle]"}),
    [](const auto& bad) { return std::string(bad.param.name); });

TEST(ReadConfiguration, CutsALongValueBetweenCharacters) {
  std::string text = "[tracker]\nfill = '";
  for (int i = 0; i < 50; ++i) text += "ä";
  const std::string message = error_of(text + "'");
  EXPECT_THAT(message, testing::HasSubstr("ä...: expected"));
}

TEST(ConfigDocument, NamesTheMissingFile) {
  try {
    ConfigDocument::load("/nowhere/lagr.toml");
    FAIL();
  } catch (const FatalError& error) {
    EXPECT_EQ(error.code(), kExitNoInput);
    EXPECT_STREQ(error.what(), "/nowhere/lagr.toml: cannot be read; expected a configuration file");
  }
}

TEST(ConfigDocument, RefusesAFolder) { EXPECT_THROW(ConfigDocument::load("/"), FatalError); }

TEST(ConfigDocument, LoadsAFile) {
  const std::string path = testing::TempDir() + "hindsight_config_document.toml";
  std::ofstream(path) << "[tracker]\nwindow_px = 5\n";
  const ConfigDocument document = ConfigDocument::load(path);
  ASSERT_EQ(document.entries.size(), 1U);
  EXPECT_EQ(document.entries[0].key, "window_px");
  EXPECT_EQ(document.file_name, path);
}

TEST(PrintConfiguration, CommentsEachKey) {
  Configuration c;
  c.tracker.window_px = 11;
  EXPECT_THAT(print_configuration(c),
              testing::StartsWith("[tracker]\n"
                                  "# side of the tracking window [px]; 3 to 31; default 9\n"
                                  "window_px = 11\n"
                                  "# least eigenvalue over the best; 0 to 1\n"
                                  "quality = 0.01\n"
                                  "# smooth first\n"
                                  "smooth = true\n"
                                  "# what an empty cell holds; one of \"zero\", \"neighbours\"\n"
                                  "fill = \"neighbours\"\n"
                                  "\n[perception.flow]\n"
                                  "# gain\n"
                                  "gain = 1.0\n"));
}

TEST(PrintConfiguration, ReadsBackExactly) {
  std::mt19937_64 random(20260801);
  for (int i = 0; i < 300; ++i) {
    Configuration c;
    do {
      const std::uint64_t bits = random();
      std::memcpy(&c.flow.gain, &bits, sizeof bits);
    } while (std::isnan(c.flow.gain));
    c.flow.weights = {std::abs(c.flow.gain), 0.1, 1e300, 5e-324};
    c.flow.device = "a \"quoted\" \\ path\n\twith \x01\x7f and ä";
    c.flow.names = {"", "#", "[x]"};
    Configuration again;
    read_configuration(again, ConfigDocument::parse(print_configuration(c), "printed"));
    EXPECT_EQ(again.flow.gain, c.flow.gain);
    EXPECT_EQ(again.flow.weights, c.flow.weights);
    EXPECT_EQ(again.flow.device, c.flow.device);
    EXPECT_EQ(again.flow.names, c.flow.names);
    EXPECT_EQ(print_configuration(again), print_configuration(c));
  }
}

TEST(PrintConfiguration, KeepsInfinityAndTheSignOfZero) {
  Configuration c;
  for (const double value : {HUGE_VAL, -HUGE_VAL, -0.0, 1e16, 123456789.0}) {
    c.flow.gain = value;
    const double again = read(print_configuration(c)).flow.gain;
    EXPECT_EQ(again, value);
    EXPECT_EQ(std::signbit(again), std::signbit(value));
  }
}

}  // namespace
}  // namespace hindsight
