// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/importer.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "sim_replay/jpeg_header.h"
#include "tests/unit/sim_replay/log_test_support.h"

namespace hindsight {
namespace {

using namespace test;

constexpr int kWidth_px = 64;
constexpr int kHeight_px = 48;

/// Stands for the vehicle's protocol: one frame a row that has wheel speeds.
class WheelsOnly : public TrackEncoder {
 public:
  void encode(const TrackRow& row, Time stamp, std::vector<CanFrame>& frames) override {
    if (row.left_mps) frames.push_back({stamp, 0x123, 1, {static_cast<std::uint8_t>(*row.left_mps)}});
  }
  std::string dbc() const override { return "VERSION \"wheels\""; }
};

cv::Mat picture(int number, int width_px = kWidth_px, int height_px = kHeight_px) {
  cv::Mat bgr(height_px, width_px, CV_8UC3);
  for (int y = 0; y < height_px; ++y) {
    for (int x = 0; x < width_px; ++x) {
      bgr.at<cv::Vec3b>(y, x) = {cv::saturate_cast<std::uint8_t>(3 * x),
                                 cv::saturate_cast<std::uint8_t>(4 * y),
                                 cv::saturate_cast<std::uint8_t>(20 * number)};
    }
  }
  return bgr;
}

/// Takes BGR and JPEG frames, as the daemon's decoder does.
bool decode(Frame& frame) {
  if (frame.format == PixelFormat::bgr24) return decode_bgr24(frame);
  const cv::Mat bgr = cv::imdecode(frame.bytes, cv::IMREAD_COLOR);
  frame.bgr.assign(bgr.datastart, bgr.dataend);
  return bgr.cols == frame.width_px && bgr.rows == frame.height_px;
}

class ImporterTest : public testing::Test {
 protected:
  ImporterTest() {
    std::filesystem::create_directories(folder_ / "frames");
    write_camera(kWidth_px, kHeight_px);
    options_ = {folder_ / "frames", 10.0, folder_ / "camera.yaml", {}, folder_ / "run.lcm", "test"};
  }

  void write_camera(int width_px, int height_px) {
    write_text(folder_ / "camera.yaml", "%YAML:1.0\nimage_width: " + std::to_string(width_px) +
                                            "\nimage_height: " + std::to_string(height_px) + "\n");
  }
  void write_picture(const std::string& name, const cv::Mat& bgr, const std::vector<int>& settings = {}) {
    ASSERT_TRUE(cv::imwrite((folder_ / "frames" / name).string(), bgr, settings));
  }
  void write_track(const std::string& text) {
    options_.track = folder_ / "track.csv";
    write_text(options_.track, text);
  }
  ImportSummary import() {
    return import_recording(options_, encoder_, [](std::uint64_t, std::uint64_t) {});
  }
  void expect_error(ExitCode code, const std::string& message) {
    EXPECT_THAT(fatal_message(code, [&] { import(); }), testing::HasSubstr(message));
    EXPECT_FALSE(std::filesystem::exists(options_.output)) << "a half log was left";
  }
  std::vector<TickInput> replay(double period_s = 0.1) {
    ReplaySource source(options_.output, pool_, decode, {false, from_seconds(period_s)});
    header_ = source.header();
    std::vector<TickInput> ticks(1);
    while (source.next(ticks.back())) ticks.emplace_back();
    ticks.pop_back();
    return ticks;
  }

  TempFolder folder_;
  WheelsOnly encoder_;
  ImportOptions options_;
  FramePool pool_{40, 1 << 16, 64 * 48};
  std::optional<RunHeader> header_;
};

TEST_F(ImporterTest, KeepsJpegsAsTheyAreAndDecodesPngs) {
  write_picture("img_2.jpg", picture(2));
  write_picture("img_10.png", picture(10));
  write_picture("img_9.JPG", picture(9));
  write_text(folder_ / "frames" / "notes.txt", "not a picture");
  const ImportSummary summary = import();
  EXPECT_EQ(summary.frames, 3U);
  EXPECT_NEAR(summary.duration_s, 0.2, 1e-9);

  const auto ticks = replay();
  ASSERT_EQ(ticks.size(), 3U);
  ASSERT_TRUE(header_);
  EXPECT_FALSE(header_->ticks_recorded);
  EXPECT_EQ(header_->build_id, "test");
  EXPECT_EQ(header_->dbc, encoder_.dbc());
  EXPECT_EQ(header_->calibration, std::string("%YAML:1.0\nimage_width: 64\nimage_height: 48\n"));
  EXPECT_EQ(ticks[0].frame->format, PixelFormat::mjpeg);
  EXPECT_EQ(ticks[0].frame->bytes, read_bytes(folder_ / "frames" / "img_2.jpg"));
  EXPECT_EQ(ticks[1].frame->bytes, read_bytes(folder_ / "frames" / "img_9.JPG"));
  EXPECT_EQ(ticks[2].frame->format, PixelFormat::bgr24);
  const cv::Mat last = picture(10);
  EXPECT_EQ(ticks[2].frame->bgr, Bytes(last.datastart, last.dataend));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(ticks[i].frame->sequence, i);
    EXPECT_EQ(ticks[i].frame->stamp, std::chrono::seconds(1) + i * std::chrono::milliseconds(100));
  }
}

TEST_F(ImporterTest, DecodesJpegsThatAreNoCamerasKind) {
  write_picture("1.jpg", picture(1), {cv::IMWRITE_JPEG_PROGRESSIVE, 1});
  cv::Mat grey(kHeight_px, kWidth_px, CV_8UC1, cv::Scalar(77));
  write_picture("2.jpg", grey);
  import();
  const auto ticks = replay();
  ASSERT_EQ(ticks.size(), 2U);
  EXPECT_EQ(ticks[0].frame->format, PixelFormat::bgr24);
  EXPECT_EQ(ticks[1].frame->format, PixelFormat::bgr24);
  EXPECT_EQ(ticks[1].frame->bgr[0], 77);
}

TEST_F(ImporterTest, PutsTheTracksSamplesBetweenTheFrames) {
  for (int i = 0; i < 5; ++i) write_picture(std::to_string(i) + ".jpg", picture(i));
  write_track(
      "time_s,left_mps,right_mps,bumper_left,estop,latitude_deg,longitude_deg,goal_east_m,goal_north_m,arm\n"
      "-0.05,1,1,0,0,,,,,\n"
      "0.05,2,2,0,0,47,8,30,40,1\n"
      "0.1,3,3,1,0,,,30,40,1\n"
      "0.1,,,1,,,,,,\n"
      "0.35,4,4,0,0,48,9,30,41,0\n");
  const ImportSummary summary = import();
  EXPECT_EQ(summary.rows, 5U);
  EXPECT_EQ(summary.can_frames, 4U);
  EXPECT_EQ(summary.edges, 4U);
  EXPECT_EQ(summary.fixes, 2U);
  EXPECT_EQ(summary.commands, 4U);
  EXPECT_NEAR(summary.duration_s, 0.45, 1e-9);

  // The first sample, 50 ms before the first frame, is at one second.
  const auto ticks = replay(0.05);
  ASSERT_EQ(ticks.size(), 10U);
  EXPECT_FALSE(ticks[0].frame);
  ASSERT_EQ(ticks[0].can.size(), 1U);
  EXPECT_EQ(ticks[0].can[0].stamp, std::chrono::seconds(1));
  ASSERT_EQ(ticks[0].edges.size(), 2U);  // the levels at start
  EXPECT_FALSE(ticks[0].edges[0].active || ticks[0].edges[1].active);
  EXPECT_TRUE(ticks[1].frame);
  ASSERT_EQ(ticks[2].commands.size(), 2U);
  EXPECT_EQ(ticks[2].commands[0].kind, CommandKind::arm);
  EXPECT_EQ(ticks[2].commands[1].kind, CommandKind::go_to_local);
  EXPECT_EQ(ticks[2].commands[1].a, 30.0);
  EXPECT_EQ(ticks[2].commands[1].b, 40.0);
  ASSERT_EQ(ticks[2].fixes.size(), 1U);
  EXPECT_EQ(ticks[2].fixes[0].longitude_deg, 8.0);
  EXPECT_TRUE(ticks[3].frame);
  ASSERT_EQ(ticks[3].edges.size(), 1U);
  EXPECT_EQ(ticks[3].edges[0].line, Line::bumper_left);
  EXPECT_TRUE(ticks[3].edges[0].active);
  EXPECT_TRUE(ticks[3].commands.empty());
  ASSERT_EQ(ticks[8].edges.size(), 1U);
  EXPECT_FALSE(ticks[8].edges[0].active);
  ASSERT_EQ(ticks[8].commands.size(), 2U);
  EXPECT_EQ(ticks[8].commands[0].kind, CommandKind::disarm);
  EXPECT_EQ(ticks[8].commands[1].b, 41.0);
}

TEST_F(ImporterTest, TakesAVideo) {
  options_.frames = folder_ / "video.avi";
  {
    cv::VideoWriter video(options_.frames.string(), cv::CAP_OPENCV_MJPEG,
                          cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 10.0, {kWidth_px, kHeight_px});
    ASSERT_TRUE(video.isOpened());
    for (int i = 0; i < 5; ++i) video.write(picture(i));
  }
  EXPECT_EQ(import().frames, 5U);
  const auto ticks = replay();
  ASSERT_EQ(ticks.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(ticks[i].frame->format, PixelFormat::mjpeg);
    const auto header = read_jpeg_header(ticks[i].frame->bytes);
    ASSERT_TRUE(header && header->baseline_colour);
    const double red = ticks[i].frame->bgr[ticks[i].frame->bgr.size() / 2 + 2];
    EXPECT_NEAR(red, 20.0 * static_cast<double>(i), 12.0);
  }
}

TEST_F(ImporterTest, NamesWhatIsAbsent) {
  options_.frames = folder_ / "none";
  expect_error(kExitNoInput, "none: no such folder or video");
  options_.frames = folder_ / "frames";
  options_.camera = folder_ / "none.yaml";
  expect_error(kExitNoInput, "none.yaml: no such file");
  options_.camera = folder_ / "camera.yaml";
  write_picture("1.jpg", picture(1));
  options_.track = folder_ / "none.csv";
  expect_error(kExitNoInput, "none.csv: cannot open the track");
}

TEST_F(ImporterTest, NamesFoldersThatCannotBeOrdered) {
  expect_error(kExitNoInput, "frames: no pictures (.jpg, .jpeg, .png) in this folder");
  write_picture("07.jpg", picture(1));
  write_picture("7.png", picture(1));
  expect_error(kExitBadData, "7.png: has the same number as 07.jpg");
  std::filesystem::remove(folder_ / "frames/7.png");
  write_picture("labels.png", picture(1));
  expect_error(kExitBadData, "labels.png: a picture without a number");
}

TEST_F(ImporterTest, NamesPicturesThatAreNone) {
  write_text(folder_ / "frames/1.png", "hello");
  expect_error(kExitBadData, "1.png: not a whole JPEG or PNG picture");
  std::filesystem::remove(folder_ / "frames/1.png");
  write_picture("1.jpg", picture(1));
  Bytes jpeg = read_bytes(folder_ / "frames/1.jpg");
  jpeg.resize(jpeg.size() / 2);
  write_bytes(folder_ / "frames/1.jpg", jpeg);
  expect_error(kExitBadData, "1.jpg: not a whole JPEG or PNG picture");
  write_text(folder_ / "frames/1.jpg", "");
  expect_error(kExitBadData, "1.jpg: not a whole JPEG or PNG picture");
  options_.frames = folder_ / "camera.yaml";
  expect_error(kExitBadData, "camera.yaml: not a video that can be decoded");
}

TEST_F(ImporterTest, NamesThePictureThatDoesNotFit) {
  write_picture("1.jpg", picture(1));
  write_picture("2.jpg", picture(2, 32, 24));
  expect_error(kExitBadData, "2.jpg: 32 x 24 pixels, but those before it have 64 x 48");
  write_camera(640, 480);
  expect_error(kExitBadData,
               "1.jpg: 64 x 48 pixels, but " + (folder_ / "camera.yaml").string() + " is for 640 x 480");
  write_text(folder_ / "camera.yaml", "%YAML:1.0\nimage_width: 64\n");
  expect_error(kExitBadData, "camera.yaml: no image_height in this camera calibration");
}

TEST_F(ImporterTest, ChecksTheWholeTrackBeforeItWrites) {
  write_picture("1.jpg", picture(1));
  write_text(options_.output, "an older log");
  write_track("time_s,left_mps\n0,1\n1,x\n");
  EXPECT_THAT(fatal_message(kExitBadData, [&] { import(); }),
              testing::HasSubstr("track.csv:3:left_mps: 'x' is not a number"));
  EXPECT_EQ(read_bytes(options_.output).size(), 12U);
}

TEST_F(ImporterTest, TellsThatTheDiskIsFull) {
  write_picture("1.jpg", picture(1));
  options_.output = "/dev/full";
  EXPECT_THAT(fatal_message(kExitIo, [&] { import(); }),
              testing::HasSubstr("/dev/full: cannot write the log: No space left"));
}

TEST(JpegHeader, IsNotReadFromAnyPrefixOfAPicture) {
  Bytes jpeg;
  cv::imencode(".jpg", picture(3), jpeg);
  ASSERT_TRUE(read_jpeg_header(jpeg));
  EXPECT_EQ(read_jpeg_header(jpeg)->width_px, kWidth_px);
  EXPECT_EQ(read_jpeg_header(jpeg)->height_px, kHeight_px);
  for (std::size_t size = 0; size < jpeg.size(); ++size) {
    const Bytes prefix(jpeg.begin(), jpeg.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_FALSE(read_jpeg_header(prefix)) << size;
  }
}

}  // namespace
}  // namespace hindsight
