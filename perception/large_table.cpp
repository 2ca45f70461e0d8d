// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/large_table.h"

#include <sys/mman.h>

#include <cstdlib>
#include <cstring>
#include <new>

namespace hindsight {

constexpr std::size_t kHugePage = std::size_t{2} << 20;

LargeTable::LargeTable(std::size_t bytes) {
  const std::size_t whole = (bytes + kHugePage - 1) / kHugePage * kHugePage;
  bytes_.reset(static_cast<std::uint8_t*>(std::aligned_alloc(kHugePage, whole)));
  if (bytes_ == nullptr) throw std::bad_alloc();
  madvise(bytes_.get(), whole, MADV_HUGEPAGE);  // a wish: nothing depends on its being granted
  std::memset(bytes_.get(), 0, whole);
}

void LargeTable::Free::operator()(std::uint8_t* bytes) const { std::free(bytes); }

}  // namespace hindsight
