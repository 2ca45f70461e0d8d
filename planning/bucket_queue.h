// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace hindsight {

/// Priority queue of grid cells for a search whose keys never fall below the key last taken (A* with a
/// consistent heuristic): a ring of buckets, each kBucketWidth keys wide, last in first out inside a bucket.
/// A key beyond the ring waits in its last bucket and has to be put in again when it comes out too early
/// (ready()).
class BucketQueue {
 public:
  /// Narrower than the cheapest step, so that hardly a cell is expanded twice.
  static constexpr unsigned kBucketShift = 9;

  explicit BucketQueue(std::size_t cells) : links_(cells) { heads_.fill(kNone); }

  /// Empty it, with no key below `least_key` to come.
  void reset(std::uint32_t least_key) {
    heads_.fill(kNone);
    occupied_.fill(0);
    cursor_ = least_key >> kBucketShift;
  }

  /// The cell must not be in the queue.
  void push(int cell, std::uint32_t key) {
    std::uint32_t bucket = key >> kBucketShift;
    if (bucket - cursor_ >= kBuckets) bucket = bucket < cursor_ ? cursor_ : cursor_ + kBuckets - 1;
    link(cell, bucket % kBuckets);
  }

  /// Gives a cell that is in the queue with `old_key` a lesser one.
  void decrease(int cell, std::uint32_t old_key, std::uint32_t new_key) {
    if (old_key >> kBucketShift == new_key >> kBucketShift) return;
    unlink(cell);
    push(cell, new_key);
  }

  /// Puts a cell that has just come out into the bucket after its own.
  void postpone(int cell) { link(cell, (cursor_ + 1) % kBuckets); }

  /// Takes a cell of the least bucket out; -1 where the queue is empty.
  int pop() {
    for (std::uint32_t tried = 0; tried <= kBuckets;) {
      const std::uint32_t slot = cursor_ % kBuckets;
      const std::uint64_t bits = occupied_[slot / 64] >> (slot % 64);
      if (bits != 0) {
        cursor_ += static_cast<std::uint32_t>(std::countr_zero(bits));
        const int cell = heads_[cursor_ % kBuckets];
        unlink(cell);
        return cell;
      }
      tried += 64 - slot % 64;
      cursor_ += 64 - slot % 64;
    }
    return -1;
  }

  /// Whether a cell that came out with this key was due, not merely waiting in the ring's last bucket.
  bool ready(std::uint32_t key) const { return key >> kBucketShift <= cursor_; }
  /// No key in the queue is less.
  std::uint32_t least_key() const { return cursor_ << kBucketShift; }

 private:
  static constexpr std::uint32_t kBuckets = 512;
  static constexpr int kNone = -1;
  /// `before` of the first cell of a bucket is -2 - slot.
  struct Links {
    int next;
    int before;
  };

  Links& links(int cell) { return links_[static_cast<std::size_t>(cell)]; }

  void link(int cell, std::uint32_t slot) {
    const int head = heads_[slot];
    links(cell) = {head, -2 - static_cast<int>(slot)};
    if (head != kNone) links(head).before = cell;
    heads_[slot] = cell;
    occupied_[slot / 64] |= std::uint64_t{1} << (slot % 64);
  }

  void unlink(int cell) {
    const Links at = links(cell);
    if (at.next != kNone) links(at.next).before = at.before;
    if (at.before >= 0) {
      links(at.before).next = at.next;
      return;
    }
    const auto slot = static_cast<std::uint32_t>(-2 - at.before);
    heads_[slot] = at.next;
    if (at.next == kNone) occupied_[slot / 64] &= ~(std::uint64_t{1} << (slot % 64));
  }

  std::vector<Links> links_;
  std::array<int, kBuckets> heads_;
  std::array<std::uint64_t, kBuckets / 64> occupied_{};
  std::uint32_t cursor_ = 0;
};

}  // namespace hindsight
