// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "drivers/samples.h"

namespace hindsight {

/// The pictures of a recording, one after the other.
class PictureSource {
 public:
  virtual ~PictureSource() = default;
  /// Fills format, size and bytes; `bgr` and the rest are left alone. False at the end. Throws FatalError 65
  /// naming the file of a picture that cannot be read.
  virtual bool next(Frame& frame) = 0;
  /// What the last picture is called in messages.
  virtual std::string name() const = 0;
  /// How many there are, 0 where a video does not tell.
  virtual std::uint64_t count() const = 0;
};

/// A folder of numbered pictures (.jpg, .jpeg, .png; numbers in their names give the order, 2 before 10) or a
/// video file. Baseline colour JPEGs stay as they are (MJPEG); other pictures become BGR; a video's frames,
/// which were compressed already, become JPEGs of quality 95, a tenth of the bytes. Throws FatalError 66
/// where nothing is there, 65 where a folder has no pictures, two of its pictures have the same number, or a
/// file is no video.
std::unique_ptr<PictureSource> open_pictures(const std::filesystem::path& path);

}  // namespace hindsight
