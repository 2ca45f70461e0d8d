// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/report_page.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "config/configuration.h"
#include "tools/html_text.h"
#include "tools/report_charts.h"
#include "tools/report_map.h"
#include "tools/report_mixture.h"
#include "tools/report_spectrogram.h"
#include "tools/report_style.h"

namespace hindsight::tools {
namespace {

constexpr int kMapPx = 1000;
constexpr int kMostSpectrogramColumns = 2000;

constexpr const char* kStyle = R"(
body{font:15px/1.5 system-ui,sans-serif;color:#1f2933;background:#f5f7f9;margin:0}
main{max-width:1160px;margin:0 auto;padding:8px 20px 60px}
h1{font-size:26px;margin:24px 0 8px} h2{font-size:19px;margin:36px 0 8px;border-bottom:2px solid #cbd2d9}
p{margin:6px 0 10px;max-width:75em}
table{border-collapse:collapse;background:#fff} td,th{padding:3px 12px;border:1px solid #e0e5ea;text-align:left}
th{background:#edf0f3;font-weight:600} .numbers td{text-align:right;font-variant-numeric:tabular-nums}
svg,img{max-width:100%;height:auto;background:#fff;display:block} svg{margin-bottom:8px}
.frames{display:grid;grid-template-columns:repeat(auto-fill,minmax(540px,1fr));gap:14px}
figure{margin:0;background:#fff;border:1px solid #e0e5ea;padding:6px} .lessons figure{margin-bottom:14px}
figcaption{font-size:13px;padding:4px 2px 0}
.swatch{display:inline-block;width:52px;height:18px;border:1px solid #9aa5b1}
.label{display:inline-block;min-width:60px;text-align:center;border-radius:3px;padding:0 6px}
.key{display:inline-block;width:12px;height:12px;margin:0 4px 0 12px;border:1px solid #9aa5b1}
)";

class Section {
 public:
  explicit Section(std::string& page) : page_(page) {}
  void begin(const std::string& title, const std::string& explanation) {
    page_ += fmt::format("<h2>{}</h2>\n<p>{}</p>\n", escape_html(title), explanation);
  }

 private:
  std::string& page_;
};

std::string row(const std::string& name, const std::string& value) {
  return fmt::format("<tr><th>{}</th><td>{}</td></tr>\n", escape_html(name), escape_html(value));
}

std::string key(Rgb color, const char* name) {
  return fmt::format("<span class='key' style='background:{}'></span>{}", color.hex(), name);
}

std::string class_keys() { return key(kGood, "good") + key(kBad, "bad") + key(kLethal, "lethal"); }

std::string touches_text(const RunTrace& trace) {
  return fmt::format("{} bumper left, {} bumper right, {} e-stop", trace.touches[0], trace.touches[1],
                     trace.touches[2]);
}

std::string events_text(const RunTrace& trace) {
  std::string text;
  for (int i = 0; i < kTrainingCauseCount; ++i) {
    const auto cause = static_cast<TrainingCause>(i);
    const auto count = std::count_if(trace.events.begin(), trace.events.end(),
                                     [cause](const EventTrace& event) { return event.cause == cause; });
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name_of(cause));
  }
  return text.empty() ? "none" : text;
}

std::string goal_text(Robot& robot, const RunTrace& trace) {
  if (!robot.goal_W()) return "no goal at the end";
  const std::string where =
      fmt::format("east {:.1f} m, north {:.1f} m: ", robot.goal_W()->x_m, robot.goal_W()->y_m);
  if (trace.reached_s) return where + fmt::format("reached at {:.1f} s", *trace.reached_s);
  const Pose2& X_WB = robot.localisation().estimate().X_WB;
  return where + fmt::format("not reached, {:.1f} m to go",
                             std::hypot(robot.goal_W()->x_m - X_WB.x_m, robot.goal_W()->y_m - X_WB.y_m));
}

std::string summary(const std::string& log, ReplayRun& run, const RunTrace& trace) {
  Robot& robot = run.robot();
  const Pose2& X_WB = robot.localisation().estimate().X_WB;
  const TerrainMixture& mixture = robot.learner().mixture();
  const auto labelled =
      std::count_if(mixture.components().begin(), mixture.components().end(),
                    [](const MixtureComponent& c) { return c.label != TerrainClass::unknown; });
  const std::time_t began = run.materials().utime_us / 1'000'000;
  std::string html = "<table>\n";
  html += row("log", log);
  html +=
      row("began", began > 86400 ? fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(began)) : "not known");
  html += row("kind", run.source().recorded_ticks() ? "recorded run"
                                                    : "imported recording, ticks made in the replay");
  html += row("duration", fmt::format("{:.1f} s, {} ticks, {} frames", trace.duration_s(), trace.ticks.size(),
                                      trace.frames));
  html += row("distance driven", fmt::format("{:.1f} m", trace.distance_m));
  html += row("touches", touches_text(trace));
  html += row("training events", events_text(trace));
  html += row("mixture", fmt::format("{} components, {} with a class, version {}",
                                     mixture.components().size(), labelled, mixture.version()));
  html += row("final pose", fmt::format("east {:.2f} m, north {:.2f} m, heading {:.1f} deg", X_WB.x_m,
                                        X_WB.y_m, X_WB.heading_rad * 180.0 / M_PI));
  html += row("goal", goal_text(robot, trace));
  html += row("late", fmt::format("{} ticks skipped by the loop, {} lost by the recorder", trace.overruns,
                                  trace.recorder_dropped));
  html += row("build", run.source().header()->build_id);
  return html + "</table>\n";
}

std::string configuration_differences(Configuration configuration) {
  Configuration defaults;
  const auto present = printed_params(configuration), usual = printed_params(defaults);
  std::string rows;
  int count = 0;
  for (std::size_t i = 0; i < present.size(); ++i) {
    if (present[i].value == usual[i].value) continue;
    ++count;
    rows += fmt::format("<tr><td>{}.{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                        escape_html(present[i].section), escape_html(present[i].key),
                        escape_html(present[i].value), escape_html(usual[i].value),
                        escape_html(present[i].description));
  }
  if (count == 0) return "<p>The configuration is that of the defaults.</p>\n";
  return fmt::format(
      "<details><summary>{} parameters differ from the defaults</summary><table>"
      "<tr><th>parameter</th><th>value</th><th>default</th><th>meaning</th></tr>\n{}</table></details>\n",
      count, rows);
}

void add_map(std::string& page, const ReportFolder& folder, ReplayRun& run, const RunTrace& trace) {
  const MapScene scene = scene_of(run, trace);
  folder.write_picture("map.png", draw_map(scene, fit_map(scene, kMapPx)));
  page += "<img src='map.png' alt='map'>\n";
}

void add_spectrograms(std::string& page, const ReportFolder& folder, ReplayRun& run, const RunTrace& trace) {
  for (const Wheel wheel : {Wheel::left, Wheel::right}) {
    const std::string file = wheel == Wheel::left ? "spectrogram_left.png" : "spectrogram_right.png";
    const cv::Mat picture =
        draw_spectrogram(trace.spectra[static_cast<std::size_t>(wheel)], kMostSpectrogramColumns);
    if (picture.empty()) continue;
    folder.write_picture(file, picture);
    page += spectrogram_chart(trace, wheel, file, run.configuration().slip);
  }
}

std::string source_keys() {
  std::string keys;
  for (int i = 0; i <= static_cast<int>(SourceState::absent); ++i) {
    const auto state = static_cast<SourceState>(i);
    keys += key(color_of(state), name_of(state));
  }
  return keys;
}

std::string or_none(const std::string& html) { return html.empty() ? "<p>None in this run.</p>\n" : html; }

}  // namespace

void write_page(const ReportFolder& folder, const std::string& log, ReplayRun& run, const RunTrace& trace,
                const Gallery& gallery, const std::string& video) {
  const std::string name = escape_html(std::filesystem::path(log).filename().string());
  std::string page = fmt::format(
      "<!doctype html>\n<html lang='en'><head><meta "
      "charset='utf-8'><title>{0}</title><style>{1}</style></head>\n"
      "<body><main><h1>Run report: {0}</h1>\n",
      name, kStyle);
  Section section(page);
  page += summary(log, run, trace) + configuration_differences(run.configuration());
  section.begin("State",
                "Sources: " + source_keys() +
                    ". Stop reason: green where motion was permitted. Point at a stretch to read it.");
  page += state_chart(trace) + speed_chart(trace, Wheel::left) + speed_chart(trace, Wheel::right);
  if (!video.empty()) {
    section.begin("Film",
                  "The run as it went by: the view, drawn over, and the map around the robot, north up.");
    page +=
        fmt::format("<p><a href='{0}'>{0}</a></p>\n<video src='{0}' controls muted width='1120'></video>\n",
                    escape_html(video));
  }
  section.begin("Map",
                "The evidence grid at the end of the run, north up." + key({129, 199, 150}, "free") +
                    key(kBad, "high cost") + key(kLethal, "lethal") + key(kUnknown, "unknown") +
                    key(kInk, "driven") + key(kRight, "planned") + key({214, 51, 132}, "goal") +
                    ". Dots: training events." +
                    (run.configuration().motion.enabled ? " Arrows: what moves there, and whereto." : ""));
  add_map(page, folder, run, trace);
  section.begin(
      "What the touches taught",
      "Left: the touched patch; right: the same ground where it was traced back to. Below: magnified.");
  page += "<div class='lessons'>" + or_none(gallery.lessons_html()) + "</div>\n";
  section.begin("Mixture",
                "The terrain mixture's components at the end, one standard deviation each; outline: class.");
  page += mixture_chart(run.robot().learner().mixture()) +
          "<details><summary>Table of the components</summary>" +
          mixture_table(run.robot().learner().mixture()) + "</details>\n";
  section.begin("Frames", class_keys() + key(kAccent, "flow") + key(kStale, "foot of the nearest obstacle") +
                              key(kPaper, "horizon, touched patch"));
  page += "<div class='frames'>" + or_none(gallery.frames_html()) + "</div>\n";
  if (trace.road_sought) {
    section.begin("Road",
                  "How much the road stands out from what lies beside it; a gap: no road is told. In the "
                  "frames above: " +
                      key(kStale, "road") + key(kPaper, "its middle"));
    page += road_chart(trace);
  }
  section.begin(
      "Slip",
      "Each wheel against the ground, which tells slip while it is seen; below, the spectrum of each motor "
      "current over time, relative to its mean.");
  if (run.configuration().ground_slip.enabled)
    page += ground_chart(trace, Wheel::left) + ground_chart(trace, Wheel::right);
  add_spectrograms(page, folder, run, trace);
  section.begin("Timing", run.source().recorded_ticks() ? "As the recorded run measured it."
                                                        : "As this replay measured it.");
  page += step_histogram(trace, 1e3 / run.configuration().robot.loop_rate_hz) + latency_histogram(trace) +
          timing_decades(trace);
  page += "</main></body></html>\n";
  folder.write_text("index.html", page);
}

}  // namespace hindsight::tools
