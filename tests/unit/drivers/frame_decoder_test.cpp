// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "drivers/frame_decoder.h"

#include <gtest/gtest.h>
#include <turbojpeg.h>

#include <cmath>
#include <cstdlib>
#include <random>

namespace hindsight {
namespace {

constexpr int kWidth = 64;
constexpr int kHeight = 48;

Frame frame_of(PixelFormat format, std::vector<std::uint8_t> bytes) {
  Frame frame;
  frame.format = format;
  frame.width_px = kWidth;
  frame.height_px = kHeight;
  frame.bytes = std::move(bytes);
  return frame;
}

/// A smooth picture with a little noise, BGR.
std::vector<std::uint8_t> picture() {
  std::mt19937 random(20260103);
  std::vector<std::uint8_t> bgr;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      for (const int base : {3 * x, 4 * y, 255 - 2 * x - y}) {
        bgr.push_back(static_cast<std::uint8_t>(std::clamp(base + static_cast<int>(random() % 8), 0, 255)));
      }
    }
  }
  return bgr;
}

std::vector<std::uint8_t> jpeg_of(std::vector<std::uint8_t> bgr) {
  tjhandle handle = tjInitCompress();
  unsigned char* out = nullptr;
  unsigned long size = 0;
  EXPECT_EQ(tjCompress2(handle, bgr.data(), kWidth, 0, kHeight, TJPF_BGR, &out, &size, TJSAMP_422, 90, 0), 0);
  std::vector<std::uint8_t> bytes(out, out + size);
  tjFree(out);
  tjDestroy(handle);
  return bytes;
}

/// Takes the Huffman tables out, as webcams do.
std::vector<std::uint8_t> without_huffman_tables(const std::vector<std::uint8_t>& jpeg) {
  std::vector<std::uint8_t> out(jpeg.begin(), jpeg.begin() + 2);
  std::size_t at = 2;
  while (at + 4 < jpeg.size() && jpeg[at + 1] != 0xDA) {  // up to the start of the scan
    const std::size_t length = 2U + (static_cast<std::size_t>(jpeg[at + 2]) << 8U) + jpeg[at + 3];
    const auto begin = jpeg.begin() + static_cast<std::ptrdiff_t>(at);
    if (jpeg[at + 1] != 0xC4) out.insert(out.end(), begin, begin + static_cast<std::ptrdiff_t>(length));
    at += length;
  }
  out.insert(out.end(), jpeg.begin() + static_cast<std::ptrdiff_t>(at), jpeg.end());
  return out;
}

int largest_difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  int largest = a.size() == b.size() ? 0 : 256;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

TEST(YuyvDecoding, AgreesWithTheFormulaForEveryColour) {
  // ITU-R BT.601, video range, in double precision.
  const auto reference = [](int y, int u, int v, std::size_t channel) {
    const double luma = 255.0 / 219.0 * (y - 16);
    const double cb = 255.0 / 224.0 * (u - 128), cr = 255.0 / 224.0 * (v - 128);
    const double blue = luma + 1.772 * cb;
    const double green = luma - 0.344136286 * cb - 0.714136286 * cr;
    const double red = luma + 1.402 * cr;
    return std::clamp(channel == 0 ? blue : channel == 1 ? green : red, 0.0, 255.0);
  };
  double largest = 0.0;
  for (int u = 0; u < 256; u += 3) {
    for (int v = 0; v < 256; v += 3) {
      std::vector<std::uint8_t> bytes;
      for (int i = 0; i < kWidth * kHeight; ++i) {
        bytes.push_back(static_cast<std::uint8_t>(i % 256));
        bytes.push_back(static_cast<std::uint8_t>(i % 2 == 0 ? u : v));
      }
      Frame frame = frame_of(PixelFormat::yuyv, bytes);
      ASSERT_EQ(decode_frame(frame), DecodeResult::ok);
      for (std::size_t i = 0; i < 256; ++i) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
          const double expected = reference(static_cast<int>(i), u, v, channel);
          largest = std::max(largest, std::abs(frame.bgr[3 * i + channel] - expected));
        }
      }
    }
  }
  EXPECT_LT(largest, 0.51) << "rounded to the nearest";
}

TEST(FrameDecoding, TakesNoMemoryForAPictureThatIsNotThere) {
  for (const PixelFormat format : {PixelFormat::yuyv, PixelFormat::mjpeg, PixelFormat::bgr24}) {
    Frame frame = frame_of(format, {1, 2, 3});
    frame.width_px = frame.height_px = 16384;
    EXPECT_NE(decode_frame(frame), DecodeResult::ok);
    EXPECT_EQ(frame.bgr.capacity(), 0U);
  }
}

TEST(YuyvDecoding, RefusesAnotherLength) {
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{kWidth * kHeight * 2 - 1}, std::size_t{kWidth * kHeight * 3}}) {
    Frame frame = frame_of(PixelFormat::yuyv, std::vector<std::uint8_t>(size));
    EXPECT_EQ(decode_frame(frame), DecodeResult::wrong_length);
  }
}

TEST(BgrDecoding, IsACopy) {
  Frame frame = frame_of(PixelFormat::bgr24, picture());
  EXPECT_EQ(decode_frame(frame), DecodeResult::ok);
  EXPECT_EQ(frame.bgr, frame.bytes);
  frame.bytes.pop_back();
  EXPECT_EQ(decode_frame(frame), DecodeResult::wrong_length);
}

class JpegDecoding : public testing::Test {
 protected:
  DecodeResult decode(std::vector<std::uint8_t> bytes) {
    frame_ = frame_of(PixelFormat::mjpeg, std::move(bytes));
    return decode_frame(frame_);
  }
  const std::vector<std::uint8_t> picture_ = picture();
  const std::vector<std::uint8_t> jpeg_ = jpeg_of(picture_);
  Frame frame_;
};

TEST_F(JpegDecoding, GivesThePicture) {
  ASSERT_EQ(decode(jpeg_), DecodeResult::ok);
  EXPECT_LT(largest_difference(frame_.bgr, picture_), 25);
}

TEST_F(JpegDecoding, KnowsFramesWithoutHuffmanTables) {
  ASSERT_EQ(decode(jpeg_), DecodeResult::ok);
  const std::vector<std::uint8_t> expected = frame_.bgr;
  ASSERT_EQ(decode(without_huffman_tables(jpeg_)), DecodeResult::ok);
  EXPECT_EQ(frame_.bgr, expected);
}

TEST_F(JpegDecoding, BearsFillerAroundTheEnd) {
  ASSERT_EQ(decode(jpeg_), DecodeResult::ok);
  const std::vector<std::uint8_t> expected = frame_.bgr;
  std::vector<std::uint8_t> padded = jpeg_;
  padded.insert(padded.end(), 100, 0);
  EXPECT_EQ(decode(padded), DecodeResult::ok);
  std::vector<std::uint8_t> filled = jpeg_;
  filled.insert(filled.end() - 2, {0, 0, 0, 0});
  EXPECT_EQ(decode(filled), DecodeResult::ok);
  EXPECT_EQ(frame_.bgr, expected);
}

TEST_F(JpegDecoding, ReportsAnotherSize) {
  frame_ = frame_of(PixelFormat::mjpeg, jpeg_);
  frame_.width_px = kWidth + 2;
  EXPECT_EQ(decode_frame(frame_), DecodeResult::wrong_size);
}

TEST_F(JpegDecoding, ReportsACutAtEveryByte) {
  for (std::size_t size = 0; size + 2 < jpeg_.size();
       ++size) {  // without the end marker the picture is whole
    EXPECT_EQ(decode({jpeg_.begin(), jpeg_.begin() + static_cast<std::ptrdiff_t>(size)}),
              DecodeResult::corrupt)
        << size;
  }
  EXPECT_EQ(decode(jpeg_), DecodeResult::ok) << "the decoder works on";
}

TEST_F(JpegDecoding, SurvivesRandomDamage) {
  std::mt19937 random(20260104);
  int reported = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<std::uint8_t> damaged = jpeg_;
    for (unsigned n = 0; n < 1 + random() % 8; ++n) {
      damaged[random() % damaged.size()] = static_cast<std::uint8_t>(random());
    }
    reported += decode(damaged) != DecodeResult::ok ? 1 : 0;
  }
  EXPECT_GT(reported, 400);  // a changed coefficient cannot be told from a picture
  EXPECT_EQ(decode(jpeg_), DecodeResult::ok) << "the decoder works on";
}

TEST_F(JpegDecoding, SurvivesNoise) {
  std::mt19937 random(20260105);
  for (int i = 0; i < 500; ++i) {
    std::vector<std::uint8_t> noise(random() % 2000);
    for (auto& byte : noise) byte = static_cast<std::uint8_t>(random());
    EXPECT_NE(decode(noise), DecodeResult::ok);
  }
}

}  // namespace
}  // namespace hindsight
