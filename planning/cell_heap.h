// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hindsight {

/// Priority queue of grid cells: a 4-ary heap, least key first, each cell in it at most once, and any cell's
/// key can be changed or the cell removed in place. Memory for every cell is reserved at construction.
class CellHeap {
 public:
  using Key = std::uint64_t;
  struct Entry {
    Key key = 0;
    int cell = 0;
  };

  explicit CellHeap(std::size_t cells) : places_(cells, kAbsent) { entries_.reserve(cells); }

  bool empty() const { return entries_.empty(); }
  std::size_t size() const { return entries_.size(); }
  const Entry& top() const { return entries_.front(); }
  bool contains(int cell) const { return place(cell) != kAbsent; }

  /// Puts the cell in, or gives it a new key.
  void set(int cell, Key key) {
    std::uint32_t at = place(cell);
    if (at == kAbsent) {
      at = static_cast<std::uint32_t>(entries_.size());
      entries_.push_back({key, cell});
      rise(at, {key, cell});
    } else if (key < entries_[at].key) {
      rise(at, {key, cell});
    } else {
      sink(at, {key, cell});
    }
  }

  void remove(int cell) {
    const std::uint32_t at = place(cell);
    if (at == kAbsent) return;
    place(cell) = kAbsent;
    const Entry last = entries_.back();
    entries_.pop_back();
    if (at == entries_.size()) return;
    if (last.key < entries_[at].key) {
      rise(at, last);
    } else {
      sink(at, last);
    }
  }

  void clear() {
    for (const Entry& entry : entries_) place(entry.cell) = kAbsent;
    entries_.clear();
  }

  /// Appends without order; heapify() must follow before any other call. The cell must not be in the heap.
  void append(int cell, Key key) { entries_.push_back({key, cell}); }
  void heapify() {
    for (std::size_t i = 0; i < entries_.size(); ++i) place(entries_[i].cell) = static_cast<std::uint32_t>(i);
    for (std::size_t i = (entries_.size() + 2) / 4; i-- > 0;)
      sink(static_cast<std::uint32_t>(i), entries_[i]);
  }

 private:
  static constexpr std::uint32_t kAbsent = 0xffffffff;

  std::uint32_t place(int cell) const { return places_[static_cast<std::size_t>(cell)]; }
  std::uint32_t& place(int cell) { return places_[static_cast<std::size_t>(cell)]; }

  void put(std::uint32_t at, const Entry& entry) {
    entries_[at] = entry;
    place(entry.cell) = at;
  }

  void rise(std::uint32_t at, Entry entry) {
    while (at > 0) {
      const std::uint32_t parent = (at - 1) / 4;
      if (entries_[parent].key <= entry.key) break;
      put(at, entries_[parent]);
      at = parent;
    }
    put(at, entry);
  }

  void sink(std::uint32_t at, Entry entry) {
    const auto count = static_cast<std::uint32_t>(entries_.size());
    for (std::uint32_t child = 4 * at + 1; child < count; child = 4 * at + 1) {
      const std::uint32_t end = child + 4 < count ? child + 4 : count;
      std::uint32_t least = child;
      for (std::uint32_t c = child + 1; c < end; ++c)
        if (entries_[c].key < entries_[least].key) least = c;
      if (entries_[least].key >= entry.key) break;
      put(at, entries_[least]);
      at = least;
    }
    put(at, entry);
  }

  std::vector<Entry> entries_;
  std::vector<std::uint32_t> places_;
};

}  // namespace hindsight
