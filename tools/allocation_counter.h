// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

namespace hindsight::tools {

/// Heap allocations that the calling thread has made since it began (malloc and all that ends in it: new, cv::Mat,
/// Eigen). Linking this puts a counting malloc in front of the C library's. Always 0 under a sanitizer, which brings
/// its own malloc.
std::uint64_t allocations_of_this_thread();

}  // namespace hindsight::tools
