// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "drivers/dbc.h"

#include <fstream>
#include <random>
#include <sstream>

#include "expect_fatal.h"

namespace hindsight {
namespace {

const std::string kLagr = HINDSIGHT_SOURCE_DIR "/config/lagr.dbc";

TEST(Dbc, ReadsTheVehiclesFile) {
  const Dbc dbc = read_dbc(kLagr);
  EXPECT_EQ(dbc.messages.size(), 6U);
  const DbcMessage* wheels = dbc.find("WHEEL_ENCODERS");
  ASSERT_NE(wheels, nullptr);
  EXPECT_EQ(wheels->id, 256U);
  EXPECT_EQ(wheels->length_bytes, 8);
  EXPECT_EQ(wheels->sender, "BASE");
  const DbcSignal* left = wheels->find("LEFT_SPEED");
  ASSERT_NE(left, nullptr);
  EXPECT_EQ(left->start_bit, 0);
  EXPECT_EQ(left->length_bits, 14);
  EXPECT_TRUE(left->little_endian);
  EXPECT_TRUE(left->is_signed);
  EXPECT_EQ(left->factor, 0.001);
  EXPECT_EQ(left->max, 5.0);
  EXPECT_EQ(left->unit, "m/s");
}

TEST(Dbc, StepsOverWhatIsNotMessages) {
  const Dbc dbc = parse_dbc(
      "VERSION \"\"\r\n"
      "NS_ :\r\n\tCM_\r\n\tBA_\r\n\tSG_MUL_VAL_\r\n\r\n"
      "BU_: A B\r\n"
      "BO_ 3221225472 VECTOR__INDEPENDENT_SIG_MSG: 0 Vector__XXX\r\n"
      " SG_ ORPHAN : 0|8@1+ (1,0) [0|0] \"\" Vector__XXX\r\n"
      "BO_ 2147483653 LONG_ID: 8 A\r\n"
      " SG_ X : 7|16@0+ (+0.5,-3e1) [-30|+100] \"m\" A,B\r\n"
      "CM_ BO_ 5 \"a text over lines,\r\nBO_ 9 with \\\"quotes\\\"\r\n SG_ in it\";\r\n"
      "BA_DEF_ BO_ \"Cycle\" INT 0 1000;\r\n"
      "VAL_ 5 X 0 \"off\" 1 \"on\" ;\r\n",
      "test.dbc");
  ASSERT_EQ(dbc.messages.size(), 1U);
  EXPECT_TRUE(dbc.messages[0].extended);
  EXPECT_EQ(dbc.messages[0].id, 5U);
  ASSERT_EQ(dbc.messages[0].signals.size(), 1U);
  EXPECT_EQ(dbc.messages[0].signals[0].factor, 0.5);
  EXPECT_EQ(dbc.messages[0].signals[0].offset, -30.0);
  EXPECT_FALSE(dbc.messages[0].signals[0].little_endian);
}

TEST(Dbc, MarksWhatItCannotDecode) {
  const Dbc dbc = parse_dbc(
      "BO_ 1 MUX: 8 A\n"
      " SG_ SWITCH M : 0|8@1+ (1,0) [0|0] \"\" B\n"
      " SG_ ONE m0 : 8|8@1+ (1,0) [0|0] \"\" B\n"
      " SG_ TWO m1 : 8|8@1+ (1,0) [0|0] \"\" B\n"
      " SG_ REAL : 32|32@1- (1,0) [0|0] \"\" B\n"
      "SIG_VALTYPE_ 1 REAL : 1;\n",
      "test.dbc");
  EXPECT_EQ(dbc.messages[0].find("ONE")->unsupported, "multiplexed");
  EXPECT_EQ(dbc.messages[0].find("REAL")->unsupported, "floating point");
}

struct BadFile {
  const char* text;
  std::vector<std::string> parts;
};

class BadDbc : public testing::TestWithParam<BadFile> {};

TEST_P(BadDbc, IsRefusedWithItsPlace) {
  expect_fatal(kExitConfiguration, GetParam().parts, [] { parse_dbc(GetParam().text, "bad.dbc"); });
}

INSTANTIATE_TEST_SUITE_P(
    All, BadDbc,
    testing::Values(
        BadFile{"", {"bad.dbc", "no message"}}, BadFile{"BO_ x MSG: 2 A\n", {"bad.dbc:1", "identifier"}},
        BadFile{"BO_ 4096 MSG: 2 A\n", {"bad.dbc:1", "11 bits"}},
        BadFile{"BO_ 1 MSG 2 A\n", {"bad.dbc:1", "':'"}},
        BadFile{"BO_ 1 MSG: 99 A\n", {"bad.dbc:1", "0 to 64 bytes"}},
        BadFile{"BO_ 1 MSG: 2 A\nBO_ 2 MSG: 2 A\n", {"bad.dbc:2", "MSG", "line 1"}},
        BadFile{"BO_ 1 MSG: 2 A\nBO_ 1 OTHER: 2 A\n", {"bad.dbc:2", "OTHER", "line 1"}},
        BadFile{"\n SG_ X : 0|8@1+ (1,0) [0|0] \"\" B\n", {"bad.dbc:2", "inside a message"}},
        BadFile{"BO_ 1 MSG: 2 A\n SG_ X : 0|8@2+ (1,0) [0|0] \"\" B\n", {"bad.dbc:2", "byte order"}},
        BadFile{"BO_ 1 MSG: 2 A\n SG_ X : 0|8@1 (1,0) [0|0] \"\" B\n", {"bad.dbc:2", "sign"}},
        BadFile{"BO_ 1 MSG: 2 A\n SG_ X : 0|8@1+ (0,0) [0|0] \"\" B\n", {"bad.dbc:2", "factor"}},
        BadFile{"BO_ 1 MSG: 2 A\n SG_ X : 0|8@1+ (1;0) [0|0] \"\" B\n", {"bad.dbc:2", "','", ";0)"}},
        BadFile{"BO_ 1 MSG: 2 A\n SG_ X : 0|8@1+ (1,0) [5|0] \"\" B\n", {"bad.dbc:2", "ascending"}},
        BadFile{"BO_ 1 MSG: 2 A\n SG_ X : 0|8@1+ (1,0) [0|0] \"m B\n", {"bad.dbc:2", "closing"}},
        BadFile{"BO_ 1 MSG: 2 A\n SG_ X : 0|65@1+ (1,0) [0|0] \"\" B\n", {"bad.dbc:2", "64 bits"}},
        BadFile{"BO_ 1 MSG: 2 A\n SG_ X : 9|8@1+ (1,0) [0|0] \"\" B\n", {"bad.dbc:2", "MSG.X", "fit"}},
        BadFile{"BO_ 1 MSG: 2 A\n SG_ X : 8|16@0+ (1,0) [0|0] \"\" B\n", {"bad.dbc:2", "MSG.X", "fit"}},
        BadFile{"BO_ 1 MSG: 2 A\n SG_ X : 0|8@1+ (1,0) [0|0] \"\" B\n SG_ Y : 7|8@1+ (1,0) [0|0] \"\" B\n",
                {"bad.dbc:3", "MSG.Y", "overlaps"}},
        BadFile{"BO_ 1 MSG: 2 A\n SG_ X : 0|4@1+ (1,0) [0|0] \"\" B\n SG_ X : 4|4@1+ (1,0) [0|0] \"\" B\n",
                {"bad.dbc:3", "MSG.X", "twice"}},
        BadFile{"BO_ 1 MSG: 2 A\nCM_ \"never\nends\n", {"bad.dbc:3", "quoted"}}));

TEST(Dbc, DamageIsAnErrorOrAnotherFileNeverACrash) {
  std::ostringstream text;
  text << std::ifstream(kLagr).rdbuf();
  const std::string whole = text.str();
  ASSERT_FALSE(whole.empty());
  std::mt19937 random(20260112);
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string damaged = whole.substr(0, i % 2 == 0 ? whole.size() : random() % whole.size());
    for (unsigned n = 0; n < 1 + random() % 20 && !damaged.empty(); ++n) {
      damaged[random() % damaged.size()] = static_cast<char>(random());
    }
    try {
      parse_dbc(damaged, "damaged.dbc");
    } catch (const FatalError& error) {
      EXPECT_EQ(error.code(), kExitConfiguration);
      ++refused;
    }
  }
  EXPECT_GT(refused, 1000);
}

TEST(Dbc, NamesAFileThatIsNotThere) {
  expect_fatal(kExitNoInput, {"/nowhere/x.dbc"}, [] { read_dbc("/nowhere/x.dbc"); });
}

}  // namespace
}  // namespace hindsight
