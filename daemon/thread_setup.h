// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

namespace hindsight {

/// As shown by top -H and gdb; at most 15 characters.
void name_this_thread(std::string_view name);

/// Stays on one processor (-1: any). Where that is not permitted, warns and goes on.
void keep_this_thread_on(int cpu);

/// SCHED_FIFO at `priority` (0: stays as it is). Where that is not permitted, warns once and goes on.
void make_this_thread_realtime(int priority);

/// What the process has in memory stays there, and so does what it gets from now on, page by page as it is touched: whole
/// stacks are not. Call it once everything large is allocated. Where that is not permitted, warns and goes on.
void lock_memory();

/// Touches the pages of this thread's stack that its work may need, so that none has to be fetched later.
void touch_stack();

}  // namespace hindsight
