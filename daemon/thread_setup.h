// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

namespace hindsight {

/// As shown by top -H and gdb; at most 15 characters.
void name_this_thread(std::string_view name);

/// SCHED_FIFO at `priority` (0: stays as it is). Where that is not permitted, warns once and goes on.
void make_this_thread_realtime(int priority);

}  // namespace hindsight
