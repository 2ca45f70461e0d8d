// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/report_charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "tools/report_spectrogram.h"
#include "tools/svg_chart.h"

namespace hindsight::tools {
namespace {

constexpr int kWidthPx = 1120;
constexpr int kBins = 60;

std::vector<double> times(const RunTrace& trace) {
  std::vector<double> out;
  for (const TickTrace& tick : trace.ticks) out.push_back(tick.time_s);
  return out;
}

template <typename Value>
std::vector<double> column(const RunTrace& trace, Value&& value) {
  std::vector<double> out;
  for (const TickTrace& tick : trace.ticks) out.push_back(value(tick));
  return out;
}

/// Calls draw(from_s, to_s, value) for each stretch of ticks with one value.
template <typename Value, typename Draw>
void for_each_stretch(const RunTrace& trace, Value&& value, Draw&& draw) {
  const auto& ticks = trace.ticks;
  for (std::size_t from = 0; from < ticks.size();) {
    std::size_t to = from + 1;
    while (to < ticks.size() && value(ticks[to]) == value(ticks[from])) ++to;
    draw(ticks[from].time_s, to < ticks.size() ? ticks[to].time_s : ticks.back().time_s, value(ticks[from]));
    from = to;
  }
}

Rgb color_of_behaviour(Behaviour behaviour) {
  constexpr std::array<Rgb, 9> colors{kFaint, kStale,  kGood,   Rgb{232, 93, 117}, kBad,
                                      kRight, kAccent, kLethal, Rgb{120, 20, 30}};
  return colors.at(static_cast<std::size_t>(behaviour));
}

Rgb color_of_stop(StopReason reason) {
  if (reason == StopReason::none) return kGood;
  if (reason == StopReason::not_armed || reason == StopReason::operator_stop ||
      reason == StopReason::watching) {
    return kStale;
  }
  return kLethal;
}

std::string stretch_tip(const char* name, double from_s, double to_s) {
  return fmt::format("{}: {:.1f} s to {:.1f} s", name, from_s, to_s);
}

double quantile(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1) + 0.5)];
}

std::string histogram(std::vector<double> values, const std::string& label, std::optional<double> period_ms) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const double median = quantile(values, 0.5), most = quantile(values, 0.99), longest = values.back();
  const double end = 1.08 * std::max({longest, period_ms.value_or(0.0), 1e-3});
  std::array<int, kBins> counts{};
  for (const double value : values)
    ++counts[std::min<std::size_t>(kBins - 1, static_cast<std::size_t>(value / end * kBins))];
  SvgChart chart(kWidthPx, 260, {0.0, end, label},
                 {0.0, 1.1 * *std::max_element(counts.begin(), counts.end()), "ticks"});
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double width = end / kBins, from = width * static_cast<double>(i);
    if (counts[i] > 0) {
      chart.box(from + 0.08 * width, from + 0.92 * width, 0.0, counts[i], kLeft,
                fmt::format("{:.1f} to {:.1f} ms: {} ticks", from, from + width, counts[i]));
    }
  }
  chart.vertical(median, kGood, {});
  chart.legend(fmt::format("median {:.2f} ms", median), kGood);
  chart.vertical(most, kBad, {});
  chart.legend(fmt::format("99 % {:.2f} ms", most), kBad);
  chart.vertical(longest, kLethal, {});
  chart.legend(fmt::format("maximum {:.2f} ms", longest), kLethal);
  if (period_ms) {
    chart.vertical(*period_ms, kInk, {});
    chart.legend(fmt::format("period {:.0f} ms", *period_ms), kInk);
  }
  return chart.text();
}

/// Names what is drawn, in the order in which it first comes.
template <typename Value, typename Color>
void add_legend(SvgChart& chart, const RunTrace& trace, Value&& value, Color&& color) {
  std::map<decltype(value(trace.ticks[0])), bool> seen;
  for (const TickTrace& tick : trace.ticks) {
    if (!std::exchange(seen[value(tick)], true)) chart.legend(name_of(value(tick)), color(value(tick)));
  }
}

struct Speeds {
  const char* name;
  Rgb color;
  std::vector<double> mps;  ///< NaN: a gap
};

/// Two speeds over time, the second drawn over the first.
std::string speeds_chart(const RunTrace& trace, const std::string& label, const Speeds& below,
                         const Speeds& above) {
  double low = 0.0, high = 0.5;
  for (const Speeds* speeds : {&below, &above}) {
    for (const double value : speeds->mps) {
      if (!std::isnan(value)) low = std::min(low, value), high = std::max(high, value);
    }
  }
  const double spare = 0.06 * (high - low);
  SvgChart chart(kWidthPx, 230, {0.0, trace.duration_s(), "time [s]"}, {low - spare, high + spare, label});
  const auto time_s = times(trace);
  for (const Speeds* speeds : {&below, &above}) chart.line(time_s, speeds->mps, speeds->color, speeds->name);
  return chart.text();
}

}  // namespace

std::string state_chart(const RunTrace& trace) {
  std::vector<std::string> rows;
  for (int i = 0; i < kSourceCount; ++i) rows.emplace_back(name_of(static_cast<Source>(i)));
  rows.insert(rows.end(), {"stop reason", "behaviour", "events"});
  SvgChart chart(kWidthPx, 74 + 26 * static_cast<int>(rows.size()), {0.0, trace.duration_s(), "time [s]"},
                 {});
  chart.name_rows(rows);
  for (std::size_t source = 0; source < kSourceCount; ++source) {
    const double row = static_cast<double>(source);
    for_each_stretch(
        trace, [source](const TickTrace& tick) { return tick.sources[source]; },
        [&](double from_s, double to_s, SourceState state) {
          chart.box(from_s, to_s, row + 0.12, row + 0.88, color_of(state),
                    stretch_tip(name_of(state), from_s, to_s));
        });
  }
  const auto stop_of = [](const TickTrace& tick) { return tick.stop; };
  for_each_stretch(trace, stop_of, [&](double from_s, double to_s, StopReason stop) {
    chart.box(from_s, to_s, 5.12, 5.88, color_of_stop(stop), stretch_tip(name_of(stop), from_s, to_s));
  });
  const auto behaviour_of = [](const TickTrace& tick) { return tick.behaviour; };
  for_each_stretch(trace, behaviour_of, [&](double from_s, double to_s, Behaviour behaviour) {
    chart.box(from_s, to_s, 6.12, 6.88, color_of_behaviour(behaviour),
              stretch_tip(name_of(behaviour), from_s, to_s));
  });
  const double hair_s = trace.duration_s() / kWidthPx;
  for (const EventTrace& event : trace.events) {
    chart.box(event.time_s - hair_s, event.time_s + hair_s, is_contact(event.cause) ? 7.0 : 7.5, 8.0,
              color_of(event.cause),
              fmt::format("{} at {:.1f} s, tick {}", name_of(event.cause), event.time_s, event.tick));
  }
  add_legend(chart, trace, behaviour_of, color_of_behaviour);
  return chart.text();
}

std::string speed_chart(const RunTrace& trace, Wheel wheel) {
  const auto side = [wheel](const DriveCommand& command) {
    return wheel == Wheel::left ? command.left_mps : command.right_mps;
  };
  return speeds_chart(
      trace, wheel == Wheel::left ? "left wheel [m/s]" : "right wheel [m/s]",
      {"measured", kLeft, column(trace, [&](const TickTrace& tick) { return side(tick.measured); })},
      {"commanded", kBad, column(trace, [&](const TickTrace& tick) { return side(tick.commanded); })});
}

std::string ground_chart(const RunTrace& trace, Wheel wheel) {
  const auto index = static_cast<std::size_t>(wheel);
  return speeds_chart(
      trace, wheel == Wheel::left ? "left wheel [m/s]" : "right wheel [m/s]",
      {"of the wheel", kLeft,
       column(trace, [&](const TickTrace& tick) { return tick.loss[index].wheel_mps; })},
      {"over the ground", kGood,
       column(trace, [&](const TickTrace& tick) { return tick.loss[index].ground_mps; })});
}

std::string road_chart(const RunTrace& trace) {
  SvgChart chart(kWidthPx, 200, {0.0, trace.duration_s(), "time [s]"}, {0.0, 1.0, "confidence"});
  chart.line(times(trace), column(trace, [](const TickTrace& tick) { return tick.road_confidence; }), kGood, "road");
  return chart.text();
}

std::string step_histogram(const RunTrace& trace, double period_ms) {
  return histogram(column(trace, [](const TickTrace& tick) { return tick.step_ms; }), "step duration [ms]",
                   period_ms);
}

std::string latency_histogram(const RunTrace& trace) {
  const auto values = column(trace, [](const TickTrace& tick) { return tick.latency_ms; });
  if (std::none_of(values.begin(), values.end(), [](double value) { return value > 0.0; })) return {};
  return histogram(values, "wake latency [ms]", std::nullopt);
}

std::string timing_decades(const RunTrace& trace) {
  const auto most = [](const TimingHistogram& histogram) { return *std::ranges::max_element(histogram.counts()); };
  const double top = std::log10(std::max({most(trace.wake_latency), most(trace.step_duration), 9}));
  SvgChart chart(kWidthPx, 260, {0.0, 6.0, "duration: 10 to the power of ... [us]"},
                 {-0.3, 1.1 * top, "ticks: 10 to the power of ..."});
  const auto draw = [&](const TimingHistogram& histogram, double from, double to, Rgb color, const char* name) {
    chart.legend(name, color);
    for (std::size_t i = 0; i + 1 < TimingHistogram::kBins; ++i) {
      const int ticks = histogram.counts()[i];
      const double begin_us = TimingHistogram::lower_edge_us(i), end_us = TimingHistogram::lower_edge_us(i + 1);
      const double begin = std::log10(begin_us), width = std::log10(end_us) - begin;
      if (ticks == 0) continue;
      chart.box(begin + from * width, begin + to * width, -0.3, std::log10(ticks), color,
                fmt::format("{}: {} ticks from {:g} to {:g} us", name, ticks, begin_us, end_us));
    }
  };
  draw(trace.wake_latency, 0.06, 0.48, kLeft, "wake latency");
  draw(trace.step_duration, 0.52, 0.94, kBad, "step duration");
  return chart.text();
}

std::string spectrogram_chart(const RunTrace& trace, Wheel wheel, const std::string& file,
                              const SlipDetectorParams& params) {
  const auto index = static_cast<std::size_t>(wheel);
  const SpectrumTrace& spectrum = trace.spectra[index];
  const double top_hz = (static_cast<double>(spectrum.bins) - 0.5) * spectrum.hz_per_bin;
  SvgChart chart(kWidthPx, 250, {0.0, trace.duration_s(), "time [s]"},
                 {0.5 * spectrum.hz_per_bin, top_hz,
                  wheel == Wheel::left ? "left motor current [Hz]" : "right motor current [Hz]"});
  chart.picture(file, 0.0, trace.duration_s(), 0.5 * spectrum.hz_per_bin, top_hz);
  for_each_stretch(
      trace, [index](const TickTrace& tick) { return tick.slipping[index]; },
      [&](double from_s, double to_s, bool slipping) {
        if (!slipping) return;
        chart.box(from_s, to_s, top_hz - 0.05 * top_hz, top_hz, kLethal, stretch_tip("slip", from_s, to_s));
      });
  chart.horizontal(params.centre_hz, kPaper, fmt::format("{:g} Hz", params.centre_hz));
  chart.legend("slip", kLethal);
  chart.legend("window not full", kFaint);
  chart.legend("amplitude 0", {68, 1, 84});
  chart.legend("0.25 of DC", {33, 145, 140});
  chart.legend(fmt::format("{:g} of DC and more", kBrightestAmplitude), {253, 231, 37});
  return chart.text();
}

}  // namespace hindsight::tools
