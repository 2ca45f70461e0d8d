// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "config/config_printer.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace hindsight {
namespace {

/// 3 rather than 3.0: a bound may belong to an integer.
std::string bound_text(double value) { return fmt::format("{}", value); }

template <class T>
std::string list_text(const std::vector<T>& values) {
  std::string text = "[";
  for (const T& value : values) text += (text.size() > 1 ? ", " : "") + toml_text(value);
  return text + "]";
}

void append_escaped(std::string& text, char c) {
  switch (c) {
    case '"':
      text += "\\\"";
      return;
    case '\\':
      text += "\\\\";
      return;
    case '\n':
      text += "\\n";
      return;
    case '\t':
      text += "\\t";
      return;
    default:
      break;
  }
  const auto code = static_cast<unsigned char>(c);
  if (code < 0x20U || code == 0x7FU) {
    fmt::format_to(std::back_inserter(text), "\\u{:04X}", code);
  } else {
    text += c;
  }
}

}  // namespace

std::string toml_text(bool value) { return value ? "true" : "false"; }
std::string toml_text(int value) { return fmt::format("{}", value); }

std::string toml_text(double value) {
  if (std::isnan(value)) return "nan";
  const std::string text = fmt::format("{}", value);
  const bool integral = text.find_first_of(".en") == std::string::npos;  // "inf" holds an n
  return integral ? text + ".0" : text;
}

std::string toml_text(std::string_view value) {
  std::string text = "\"";
  for (const char c : value) append_escaped(text, c);
  return text + "\"";
}

std::string toml_text(const std::string& value) { return toml_text(std::string_view(value)); }
std::string toml_text(const std::vector<double>& value) { return list_text(value); }
std::string toml_text(const std::vector<std::string>& value) { return list_text(value); }

std::string allowed_text(const Range& allowed) {
  const bool has_min = std::isfinite(allowed.min), has_max = std::isfinite(allowed.max);
  if (has_min && has_max) return bound_text(allowed.min) + " to " + bound_text(allowed.max);
  if (has_min) return "at least " + bound_text(allowed.min);
  if (has_max) return "at most " + bound_text(allowed.max);
  return "";
}

std::string allowed_text(const Choices& allowed) {
  std::string text;
  for (const std::string_view value : allowed.values)
    text += (text.empty() ? "one of " : ", ") + toml_text(value);
  return text;
}

std::string allowed_text(AnyText) { return ""; }
std::string allowed_text(YesNo) { return ""; }

std::string toml_file(const std::vector<PrintedParam>& params, const std::vector<PrintedParam>& defaults) {
  std::string text;
  std::string section;
  for (std::size_t i = 0; i < params.size(); ++i) {
    const PrintedParam& param = params[i];
    if (i == 0 || param.section != section) {
      section = param.section;
      text += fmt::format("{}[{}]\n", text.empty() ? "" : "\n", section);
    }
    text += "# " + param.description;
    if (!param.allowed.empty()) text += "; " + param.allowed;
    if (param.value != defaults[i].value) text += "; default " + defaults[i].value;
    text += fmt::format("\n{} = {}\n", param.key, param.value);
  }
  return text;
}

}  // namespace hindsight
