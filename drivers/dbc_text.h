// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>

#include "config/exit_code.h"

namespace hindsight {

inline bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
inline bool is_word(char c) {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
}

/// Reads one line from left to right; whatever is not as expected is an error that names the place.
class LineScanner {
 public:
  LineScanner(std::string_view line, std::string place) : rest_(line), place_(std::move(place)) {}

  [[noreturn]] void fail(const std::string& expected) const {
    throw FatalError(kExitConfiguration,
                     fmt::format("{}: expected {}, found \"{}\"", place_, expected, rest_));
  }
  const std::string& place() const { return place_; }

  bool accept(char c) {
    skip_blanks();
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void expect(char c) {
    if (!accept(c)) fail(fmt::format("'{}'", c));
  }
  /// A C identifier, or an empty string where there is none.
  std::string word() {
    skip_blanks();
    const auto end = std::find_if_not(rest_.begin(), rest_.end(), is_word);
    return take(static_cast<std::size_t>(end - rest_.begin()));
  }
  std::string name(const char* what) {
    std::string text = word();
    if (text.empty() || (text.front() >= '0' && text.front() <= '9')) fail(what);
    return text;
  }
  template <class Number>
  Number number(const char* what) {
    skip_blanks();
    if (!rest_.empty() && rest_.front() == '+') rest_.remove_prefix(1);
    Number value{};
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc{}) fail(what);
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }
  std::string quoted() {
    expect('"');
    const std::size_t end = rest_.find('"');
    if (end == std::string_view::npos) fail("a closing '\"'");
    std::string text = take(end);
    rest_.remove_prefix(1);
    return text;
  }

 private:
  void skip_blanks() {
    while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
  }
  std::string take(std::size_t count) {
    std::string text(rest_.substr(0, count));
    rest_.remove_prefix(count);
    return text;
  }

  std::string_view rest_;
  std::string place_;
};

/// Splits the text into lines, and knows which of them begin inside a quoted text (comments run over lines).
class LineSplitter {
 public:
  explicit LineSplitter(std::string_view text) : rest_(text) {}

  bool next(std::string_view& line) {
    if (rest_.empty()) return false;
    began_quoted_ = quoted_;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == '\\' && quoted_)
        ++i;
      else if (line[i] == '"')
        quoted_ = !quoted_;
    }
    return true;
  }
  bool began_quoted() const { return began_quoted_; }
  bool quoted() const { return quoted_; }
  int number() const { return number_; }

 private:
  std::string_view rest_;
  bool quoted_ = false;
  bool began_quoted_ = false;
  int number_ = 0;
};

}  // namespace hindsight
