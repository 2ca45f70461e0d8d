// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/publisher.h"

#include <lcm/lcm.h>
#include <turbojpeg.h>

#include <bot_core/image_t.hpp>
#include <vector>

#include "daemon/say.h"

namespace hindsight {
namespace {

constexpr Time kPauseBetweenTries = from_seconds(5.0);
constexpr int kPreviewShrink = 2;
/// Larger messages are lost by receivers with the system's default socket buffer.
constexpr std::size_t kMostPreviewBytes = 60000;
constexpr std::int32_t kMjpeg = 1196444237;

/// Every second pixel of every second row: a preview is for the eye.
void shrink(const Frame& frame, std::vector<std::uint8_t>& small) {
  const int width = frame.width_px / kPreviewShrink;
  const int height = frame.height_px / kPreviewShrink;
  small.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
  std::size_t to = 0;
  for (int y = 0; y < height; ++y) {
    const auto row = static_cast<std::size_t>(y * kPreviewShrink) * static_cast<std::size_t>(frame.width_px) * 3;
    for (int x = 0; x < width; ++x) {
      const std::size_t from = row + static_cast<std::size_t>(x * kPreviewShrink) * 3;
      for (std::size_t c = 0; c < 3; ++c) small[to++] = frame.bgr[from + c];
    }
  }
}

}  // namespace

struct Publisher::Preview {
  tjhandle compressor = tjInitCompress();
  std::vector<std::uint8_t> small;
  bot_core::image_t message{};

  Preview() = default;
  Preview(const Preview&) = delete;
  Preview& operator=(const Preview&) = delete;
  ~Preview() { tjDestroy(compressor); }
};

Publisher::Publisher(const TelemetryParams& params) : params_(params), preview_(std::make_unique<Preview>()) {}

Publisher::~Publisher() {
  if (lcm_ != nullptr) lcm_destroy(static_cast<lcm_t*>(lcm_));
}

bool Publisher::connect(Time now) {
  if (lcm_ != nullptr) return true;
  if (params_.lcm_url.empty() || now < next_try_) return false;
  next_try_ = now + kPauseBetweenTries;
  lcm_ = lcm_create(params_.lcm_url.c_str());
  if (lcm_ == nullptr) say(Severity::warning, "no telemetry: cannot open LCM at {}", params_.lcm_url);
  return lcm_ != nullptr;
}

void Publisher::send(const std::string& channel, std::span<const std::uint8_t> bytes) {
  // A packet that the network refuses is lost, as any packet may be; the next tick brings a newer one.
  lcm_publish(static_cast<lcm_t*>(lcm_), channel.c_str(), bytes.data(), static_cast<unsigned>(bytes.size()));
}

void Publisher::publish(const Outbox& outbox, const FrameRef& frame, Time now, std::int64_t utime_us) {
  if (!connect(now)) return;
  for (const Outbox::Message& message : outbox.messages()) send(std::string(message.channel), message.bytes);
  if (params_.preview_hz > 0.0 && frame && now >= next_preview_) {
    next_preview_ = now + from_seconds(1.0 / params_.preview_hz);
    publish_preview(*frame, utime_us);
  }
}

void Publisher::publish_preview(const Frame& frame, std::int64_t utime_us) {
  bot_core::image_t& m = preview_->message;
  shrink(frame, preview_->small);
  m.utime = utime_us;
  m.width = frame.width_px / kPreviewShrink;
  m.height = frame.height_px / kPreviewShrink;
  m.pixelformat = kMjpeg;
  unsigned char* jpeg = nullptr;
  unsigned long size = 0;
  const int result = tjCompress2(preview_->compressor, preview_->small.data(), m.width, 0, m.height, TJPF_BGR, &jpeg,
                                 &size, TJSAMP_420, params_.preview_quality, 0);
  if (result == 0 && size <= kMostPreviewBytes) {
    m.data.assign(jpeg, jpeg + size);
    m.size = static_cast<std::int32_t>(size);
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(m.getEncodedSize()));
    m.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
    send("HINDSIGHT_PREVIEW", bytes);
  }
  tjFree(jpeg);
}

}  // namespace hindsight
