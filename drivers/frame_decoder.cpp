// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "drivers/frame_decoder.h"

#include <turbojpeg.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>

namespace hindsight {
namespace {

// BT.601 with the video range, in units of 2^-16: 255/219, and 255/224 times 1.402, 0.344136,
// 0.714136, 1.772.
constexpr int kBits = 16;
constexpr int kHalf = 1 << (kBits - 1);
constexpr int kLuma = 76309;
constexpr int kRedV = 104597;
constexpr int kGreenU = 25675;
constexpr int kGreenV = 53279;
constexpr int kBlueU = 132201;

std::size_t pixels_of(const Frame& frame) {
  return static_cast<std::size_t>(frame.width_px) * static_cast<std::size_t>(frame.height_px);
}

std::uint8_t to_byte(int scaled) { return static_cast<std::uint8_t>(std::clamp(scaled >> kBits, 0, 255)); }

// Pairs of pixels are converted into planes first and interleaved then: so the compiler vectorises the sums.
constexpr std::size_t kBlock = 64;

void convert_block(const std::uint8_t* yuyv, std::uint8_t* bgr, std::size_t pairs) {
  std::array<std::array<std::uint8_t, kBlock>, 6> planes;  // B, G, R of the first pixel, then of the second
  for (std::size_t i = 0; i < pairs; ++i) {
    const int u = yuyv[4 * i + 1] - 128;
    const int v = yuyv[4 * i + 3] - 128;
    const int blue = kBlueU * u + kHalf;
    const int green = -kGreenU * u - kGreenV * v + kHalf;
    const int red = kRedV * v + kHalf;
    const int y0 = kLuma * (yuyv[4 * i] - 16);
    const int y1 = kLuma * (yuyv[4 * i + 2] - 16);
    planes[0][i] = to_byte(y0 + blue);
    planes[1][i] = to_byte(y0 + green);
    planes[2][i] = to_byte(y0 + red);
    planes[3][i] = to_byte(y1 + blue);
    planes[4][i] = to_byte(y1 + green);
    planes[5][i] = to_byte(y1 + red);
  }
  for (std::size_t i = 0; i < pairs; ++i) {
    for (std::size_t k = 0; k < planes.size(); ++k) bgr[6 * i + k] = planes[k][i];
  }
}

void yuyv_to_bgr(const std::uint8_t* yuyv, std::uint8_t* bgr, std::size_t pairs) {
  for (std::size_t first = 0; first < pairs; first += kBlock) {
    convert_block(yuyv + 4 * first, bgr + 6 * first, std::min(kBlock, pairs - first));
  }
}

// Many webcams leave filler bytes before the end marker. When that is libjpeg's first complaint, each block
// of the picture has been decoded without one.
bool is_harmless(const std::string& warning) {
  return warning.find("extraneous bytes before marker 0xd9") != std::string::npos;
}

struct Closer {
  void operator()(void* handle) const { tjDestroy(handle); }
};

// A decompressor remembers tables, and a damaged frame can leave it unusable: each frame gets its own
// (microseconds).
DecodeResult decode_jpeg(Frame& frame) {
  // The exact DCT gives the same picture with and without SIMD; the limit on scans stops bombs.
  constexpr int kFlags = TJFLAG_ACCURATEDCT | TJFLAG_LIMITSCANS;
  const std::unique_ptr<void, Closer> handle(tjInitDecompress());
  int width = 0, height = 0, subsampling = 0, colourspace = 0;
  if (!handle || tjDecompressHeader3(handle.get(), frame.bytes.data(), frame.bytes.size(), &width, &height,
                                     &subsampling, &colourspace) != 0) {
    return DecodeResult::corrupt;
  }
  if (width <= 0 || height <= 0) return DecodeResult::corrupt;  // tables without a picture
  if (width != frame.width_px || height != frame.height_px) return DecodeResult::wrong_size;
  frame.bgr.resize(pixels_of(frame) * 3);
  if (tjDecompress2(handle.get(), frame.bytes.data(), frame.bytes.size(), frame.bgr.data(), width, 0, height,
                    TJPF_BGR, kFlags) == 0) {
    return DecodeResult::ok;
  }
  const bool only_warned = tjGetErrorCode(handle.get()) == TJERR_WARNING;
  return only_warned && is_harmless(tjGetErrorStr2(handle.get())) ? DecodeResult::ok : DecodeResult::corrupt;
}

}  // namespace

std::string_view to_string(DecodeResult result) {
  switch (result) {
    case DecodeResult::ok:
      return "ok";
    case DecodeResult::wrong_length:
      return "wrong length";
    case DecodeResult::wrong_size:
      return "wrong size";
    case DecodeResult::corrupt:
      break;
  }
  return "corrupt";
}

// Memory for the picture is taken once its bytes have been seen to fit: what a frame says of its size may be a lie.
DecodeResult decode_frame(Frame& frame) {
  const std::size_t pixels = pixels_of(frame);
  switch (frame.format) {
    case PixelFormat::yuyv:
      if (frame.width_px % 2 != 0 || frame.bytes.size() != pixels * 2) return DecodeResult::wrong_length;
      frame.bgr.resize(pixels * 3);
      yuyv_to_bgr(frame.bytes.data(), frame.bgr.data(), pixels / 2);
      return DecodeResult::ok;
    case PixelFormat::bgr24:
      if (frame.bytes.size() != pixels * 3) return DecodeResult::wrong_length;
      frame.bgr.assign(frame.bytes.begin(), frame.bytes.end());
      return DecodeResult::ok;
    case PixelFormat::mjpeg:
      break;
  }
  return decode_jpeg(frame);
}

}  // namespace hindsight
