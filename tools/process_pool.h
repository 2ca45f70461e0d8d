// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <string>

namespace hindsight::tools {

/// Does `count` pieces of work in processes of their own, `at_once` at a time, each of which renders with one
/// thread: work(i) returns a text, and done(i, text) gets it in this process, in order of completion. A piece
/// whose process fails has said why on standard error; done() is not called for it. Returns the number of
/// those.
int run_in_processes(int count, int at_once, const std::function<std::string(int)>& work,
                     const std::function<void(int, const std::string&)>& done);

}  // namespace hindsight::tools
