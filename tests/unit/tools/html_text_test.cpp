// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/html_text.h"

#include <gtest/gtest.h>

namespace hindsight::tools {
namespace {

TEST(HtmlText, ReplacesWhatHtmlWouldTakeForMarkup) {
  EXPECT_EQ(escape_html("<b a=\"1\" b='2'>&</b>"), "&lt;b a=&quot;1&quot; b=&#39;2&#39;&gt;&amp;&lt;/b&gt;");
}

TEST(HtmlText, KeepsTextLineFeedsAndUtf8) { EXPECT_EQ(escape_html("a\tb\n5 \xC2\xB0"), "a\tb\n5 \xC2\xB0"); }

TEST(HtmlText, ReplacesControlCharacters) {
  EXPECT_EQ(escape_html(std::string_view("a\0b\x1b[1m\x7f", 8)), "a?b?[1m?");
}

}  // namespace
}  // namespace hindsight::tools
