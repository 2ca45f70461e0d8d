// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// A camera's JPEG: its header as the importer reads it, the picture as camera and replay decode it, of a size
// that the header gives and of another.
#include "drivers/frame_decoder.h"
#include "fuzz.h"
#include "sim_replay/jpeg_header.h"

namespace hindsight::fuzz {
namespace {

/// A larger picture than any camera of ours has takes only time.
constexpr int kMostPixels = 1 << 20;

void decode(Bytes bytes, PixelFormat format, int width_px, int height_px) {
  Frame frame;
  frame.format = format;
  frame.width_px = width_px;
  frame.height_px = height_px;
  frame.bytes.assign(bytes.begin(), bytes.end());
  if (decode_frame(frame) != DecodeResult::ok) return;
  require(frame.bgr.size() == static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px) * 3,
          "a picture is as large as its frame says");
}

void run(Bytes bytes) {
  for (const PixelFormat format : {PixelFormat::yuyv, PixelFormat::mjpeg, PixelFormat::bgr24}) {
    decode(bytes, format, 32, 24);
  }
  const auto header = read_jpeg_header(bytes);
  if (header && std::int64_t{header->width_px} * header->height_px <= kMostPixels) {
    decode(bytes, PixelFormat::mjpeg, header->width_px, header->height_px);
  }
}

}  // namespace
}  // namespace hindsight::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  hindsight::fuzz::run({data, size});
  return 0;
}
