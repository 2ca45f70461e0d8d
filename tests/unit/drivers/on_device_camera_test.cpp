// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include <fcntl.h>
#include <linux/videodev2.h>
#include <sys/eventfd.h>
#include <sys/ioctl.h>

#include <atomic>
#include <thread>

#include "drivers/v4l2_camera.h"
#include "expect_fatal.h"
#include "on_device.h"

namespace hindsight {
namespace {

// ---- vivid

class Vivid : public OnDevice {
 protected:
  static CameraParams params() {
    CameraParams result;
    result.format.device = "/dev/video0";
    result.format.width_px = 640;
    result.format.height_px = 360;
    result.format.rate_hz = 30;
    result.restart_s = 1.0;
    return result;
  }
  /// Sets a control of vivid by its name, through a descriptor of its own.
  static void set_control(const char* name, int value) {
    const UniqueFd fd(::open("/dev/video0", O_RDWR | O_CLOEXEC));
    v4l2_queryctrl query{};
    query.id = V4L2_CTRL_FLAG_NEXT_CTRL;
    while (::ioctl(fd.get(), VIDIOC_QUERYCTRL, &query) == 0) {
      if (std::string(reinterpret_cast<const char*>(query.name)) == name) {
        v4l2_control control{.id = query.id, .value = value};
        ASSERT_EQ(::ioctl(fd.get(), VIDIOC_S_CTRL, &control), 0) << name;
        return;
      }
      query.id |= V4L2_CTRL_FLAG_NEXT_CTRL;
    }
    FAIL() << "no control " << name;
  }
  bool serve_until(V4l2Camera& camera, SourceState state) {
    return serve(camera, [&] { return sink_.last_state_is(state); });
  }
  FramePool pool_{6, 1280 * 720 * 2, 1280 * 720};
};

TEST_F(Vivid, StreamsWithKernelStamps) {
  const Time before = monotonic_now();
  V4l2Camera camera(params(), pool_, sink_);
  ASSERT_TRUE(serve(camera, [&] { return sink_.frame_stamps.size() >= 10; }));
  for (std::size_t i = 0; i < sink_.frame_stamps.size(); ++i) {
    EXPECT_GT(sink_.frame_stamps[i], i == 0 ? before : sink_.frame_stamps[i - 1]);
    EXPECT_LE(sink_.frame_stamps[i], monotonic_now());
  }
  EXPECT_EQ(sink_.last_frame->bytes.size(), 640U * 360U * 2U);
  EXPECT_EQ(sink_.last_frame->bgr.size(), 640U * 360U * 3U);
  EXPECT_GT(sink_.last_frame->gain, 0.0F) << "vivid tells its gain";
  EXPECT_EQ(sink_.reports.front().state, SourceState::fresh);
}

TEST_F(Vivid, AnotherSizeIsRefusedSayingBoth) {
  CameraParams wrong = params();
  wrong.format.width_px = 700;
  expect_fatal(kExitNoDevice, {"/dev/video0", "asked for 700 x 360 YUYV", "gives 640 x 360 YUYV"},
               [&] { V4l2Camera(wrong, pool_, sink_); });
}

TEST_F(Vivid, AnotherFormatIsRefusedSayingBoth) {
  CameraParams wrong = params();
  wrong.format.format = "mjpeg";
  expect_fatal(kExitNoDevice, {"/dev/video0", "asked for 640 x 360 MJPG", "gives 640 x 360 YUYV"},
               [&] { V4l2Camera(wrong, pool_, sink_); });
}

TEST_F(Vivid, ABusyCameraIsRefused) {
  const V4l2Camera first(params(), pool_, sink_);
  expect_fatal(kExitNoDevice, {"/dev/video0", "busy"}, [&] { V4l2Camera(params(), pool_, sink_); });
}

TEST_F(Vivid, ALateServiceGetsTheNewestFrame) {
  V4l2Camera camera(params(), pool_, sink_);
  ASSERT_TRUE(serve_until(camera, SourceState::fresh));
  std::this_thread::sleep_for(milliseconds(110));
  const std::size_t before = sink_.frame_stamps.size();
  camera.service(milliseconds(20));
  EXPECT_EQ(sink_.frame_stamps.size(), before + 1);
  EXPECT_GE(camera.statistics().outdated, 1U);
}

TEST_F(Vivid, AHeldPoolCostsFramesOnly) {
  FramePool small(1, 640 * 360 * 2, 640 * 360);
  V4l2Camera camera(params(), small, sink_);
  ASSERT_TRUE(serve(camera, [&] { return camera.statistics().no_slot >= 3; }))
      << "the sink holds the only slot";
  sink_.last_frame = {};
  ASSERT_TRUE(serve(camera, [&] { return camera.statistics().delivered >= 2; }));
}

TEST_F(Vivid, ComesBackAfterADisconnection) {
  V4l2Camera camera(params(), pool_, sink_);
  ASSERT_TRUE(serve_until(camera, SourceState::fresh));
  const Time unplugged = monotonic_now();
  set_control("Disconnect", 1);
  ASSERT_TRUE(serve_until(camera, SourceState::failed));
  EXPECT_LT(sink_.reports.back().stamp - unplugged, milliseconds(300));
  EXPECT_EQ(sink_.reports.back().error_code, ENODEV);
  ASSERT_TRUE(serve_until(camera, SourceState::fresh));
  EXPECT_GE(camera.statistics().reopened, 1U);
}

TEST_F(Vivid, AStallIsToldAndCuredByReopening) {
  V4l2Camera camera(params(), pool_, sink_);
  ASSERT_TRUE(serve_until(camera, SourceState::fresh));
  set_control("Percentage of Dropped Buffers", 100);
  const Time stalled = monotonic_now();
  ASSERT_TRUE(serve_until(camera, SourceState::stale));
  EXPECT_LT(sink_.reports.back().stamp - stalled, milliseconds(400));
  ASSERT_TRUE(serve_until(camera, SourceState::failed));
  EXPECT_EQ(sink_.reports.back().error_code, ETIMEDOUT);
  set_control("Percentage of Dropped Buffers", 0);
  EXPECT_TRUE(serve_until(camera, SourceState::fresh));
}

TEST_F(Vivid, BrokenBuffersAreDroppedAndCounted) {
  V4l2Camera camera(params(), pool_, sink_);
  ASSERT_TRUE(serve_until(camera, SourceState::fresh));
  for (int i = 0; i < 5; ++i) {
    set_control("Inject V4L2_BUF_FLAG_ERROR", 1);
    ASSERT_TRUE(serve(camera, [&] { return camera.statistics().frames.broken > static_cast<unsigned>(i); }))
        << i;
  }
  EXPECT_TRUE(serve(camera, [&] { return sink_.reports.back().dropped >= 5; }));
}

TEST_F(Vivid, AStopRequestWakesIt) {
  CameraParams slow = params();
  V4l2Camera camera(slow, pool_, sink_);
  const UniqueFd stop(::eventfd(1, EFD_CLOEXEC | EFD_NONBLOCK));
  const Time before = monotonic_now();
  camera.service(milliseconds(10000), stop.get());
  EXPECT_LT(monotonic_now() - before, milliseconds(200));
}

// ---- v4l2loopback

class Loopback : public OnDevice {
 protected:
  static constexpr int kWidth = 720;
  static constexpr int kHeight = 480;

  /// A program that feeds the loopback camera. `make` gives the bytes of frame i.
  class Feeder {
   public:
    Feeder(std::uint32_t fourcc, std::function<std::vector<std::uint8_t>(int)> make)
        : fd_(::open("/dev/video10", O_RDWR | O_CLOEXEC)) {
      v4l2_format format{};
      format.type = V4L2_BUF_TYPE_VIDEO_OUTPUT;
      format.fmt.pix.width = kWidth;
      format.fmt.pix.height = kHeight;
      format.fmt.pix.pixelformat = fourcc;
      format.fmt.pix.field = V4L2_FIELD_NONE;
      format.fmt.pix.sizeimage = kWidth * kHeight * 2;
      EXPECT_EQ(::ioctl(fd_.get(), VIDIOC_S_FMT, &format), 0);
      feed(make(0));
      thread_ = std::thread([this, make] {
        for (int i = 1; !stop_; ++i) {
          std::this_thread::sleep_for(milliseconds(30));
          if (!paused_) feed(make(i));
        }
      });
    }
    ~Feeder() {
      stop_ = true;
      thread_.join();
    }
    std::atomic<bool> paused_{false};

   private:
    void feed(const std::vector<std::uint8_t>& bytes) {
      EXPECT_EQ(::write(fd_.get(), bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
    }
    UniqueFd fd_;
    std::atomic<bool> stop_{false};
    std::thread thread_;
  };

  static std::vector<std::uint8_t> grey(int i) {
    std::vector<std::uint8_t> bytes(kWidth * kHeight * 2, 128);
    for (std::size_t k = 0; k < bytes.size(); k += 2) bytes[k] = static_cast<std::uint8_t>(16 + i % 200);
    return bytes;
  }
  static CameraParams params(const char* format) {
    CameraParams result;
    result.format.device = "/dev/video10";
    result.format.format = format;
    return result;
  }
  FramePool pool_{6, kWidth* kHeight * 2, kWidth* kHeight};
};

TEST_F(Loopback, GivesWhatWasFed) {
  Feeder feeder(V4L2_PIX_FMT_YUYV, grey);
  V4l2Camera camera(params("yuyv"), pool_, sink_);
  ASSERT_TRUE(serve(camera, [&] { return sink_.frame_stamps.size() >= 10; }));
  const std::uint8_t luma = sink_.last_frame->bytes[0];
  EXPECT_EQ(sink_.last_frame->bytes, grey(luma - 16));
  EXPECT_LE(sink_.frame_stamps.back(), monotonic_now());
  EXPECT_GT(sink_.frame_stamps.back(), monotonic_now() - milliseconds(500));
  EXPECT_EQ(camera.statistics().frames.wrong_length, 0U);
}

TEST_F(Loopback, AFeederThatPausesIsAStall) {
  Feeder feeder(V4L2_PIX_FMT_YUYV, grey);
  V4l2Camera camera(params("yuyv"), pool_, sink_);
  ASSERT_TRUE(serve(camera, [&] { return sink_.last_state_is(SourceState::fresh); }));
  feeder.paused_ = true;
  ASSERT_TRUE(serve(camera, [&] { return sink_.last_state_is(SourceState::stale); }));
  feeder.paused_ = false;
  EXPECT_TRUE(serve(camera, [&] { return sink_.last_state_is(SourceState::fresh); }));
}

TEST_F(Loopback, AJpegThatIsNoneIsDroppedAndCounted) {
  Feeder feeder(V4L2_PIX_FMT_MJPEG,
                [](int i) { return std::vector<std::uint8_t>(1000 + static_cast<std::size_t>(i), 7); });
  V4l2Camera camera(params("mjpeg"), pool_, sink_);
  EXPECT_TRUE(serve(camera, [&] { return camera.statistics().undecodable >= 5; }));
  EXPECT_TRUE(sink_.frame_stamps.empty());
}

TEST_F(Loopback, AnotherSizeIsRefusedSayingBoth) {
  Feeder feeder(V4L2_PIX_FMT_YUYV, grey);
  CameraParams wrong = params("yuyv");
  wrong.format.width_px = 640;
  expect_fatal(kExitNoDevice, {"/dev/video10", "640 x 480", "720 x 480"},
               [&] { V4l2Camera(wrong, pool_, sink_); });
}

}  // namespace
}  // namespace hindsight
