// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/verify_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "config/exit_code.h"
#include "daemon/replay_run.h"
#include "tools/message_schema.h"

namespace hindsight::tools {
namespace {

/// The first field that differs between two encodings of a message of one type.
std::string first_difference(std::string_view channel, std::span<const std::uint8_t> recorded,
                             std::span<const std::uint8_t> replayed) {
  const std::size_t common = std::min(recorded.size(), replayed.size());
  const auto differ = std::mismatch(recorded.begin(), recorded.begin() + static_cast<std::ptrdiff_t>(common),
                                    replayed.begin());
  const auto offset = static_cast<std::size_t>(differ.first - recorded.begin());
  const std::string type = type_of_channel(channel);
  const auto in_log = telemetry_schema().fields(type, recorded);
  const auto in_replay = telemetry_schema().fields(type, replayed);
  const auto covers = [offset](const MessageSchema::Field& field) {
    return offset >= field.offset && offset < field.offset + field.size;
  };
  const auto field = std::find_if(in_log.begin(), in_log.end(), covers);
  const auto other = std::find_if(in_replay.begin(), in_replay.end(), covers);
  if (field == in_log.end() || other == in_replay.end()) return fmt::format("byte {}", offset);
  return fmt::format("field {}: the log has {}, the replay {}", field->path, field->value, other->value);
}

/// Empty where the tick published what the log holds.
std::string compare_tick(const ReplayRun& run) {
  const auto recorded = std::span(run.recorded());
  const auto replayed = run.outbox().messages();
  for (std::size_t i = 0; i < std::max(recorded.size(), replayed.size()); ++i) {
    if (i >= replayed.size()) return fmt::format("channel {}: in the log, not in the replay", recorded[i].channel);
    if (i >= recorded.size()) return fmt::format("channel {}: in the replay, not in the log", replayed[i].channel);
    if (recorded[i].channel != replayed[i].channel) {
      return fmt::format("channel {} in the log, {} in the replay", recorded[i].channel, replayed[i].channel);
    }
    if (!std::ranges::equal(recorded[i].bytes, replayed[i].bytes)) {
      return fmt::format("channel {}, {}", recorded[i].channel,
                         first_difference(recorded[i].channel, recorded[i].bytes, replayed[i].bytes));
    }
  }
  return {};
}

/// A flight recorder's log: what the robot had learned and mapped before is not in it.
int tell_beginning(const std::string& log, std::uint64_t index) {
  fmt::print(
      "{}: begins with tick {} of its run; what the robot knew by then is not in the log, so a replay cannot publish the "
      "same. hindsightd --replay and hindsight report take it as it is\n",
      log, index);
  return kExitDiffers;
}

}  // namespace

int verify_run(const std::string& log) {
  ReplayRun run(log, std::nullopt, false);
  if (!run.source().recorded_ticks()) {
    throw FatalError(kExitBadData, log + ": holds no ticks: record a run first (hindsightd --replay LOG --record OUT)");
  }
  std::uint64_t ticks = 0;
  std::uint64_t messages = 0;
  while (run.step()) {
    if (ticks == 0 && run.input().index > 0) return tell_beginning(log, run.input().index);
    const std::string difference = compare_tick(run);
    if (!difference.empty()) {
      fmt::print("{}: differs first in tick {}, {}\n", log, run.input().index, difference);
      return kExitDiffers;
    }
    ++ticks;
    messages += run.recorded().size();
  }
  if (run.source().losses().unrecorded_ticks > 0) {
    fmt::print("{}: {} ticks were never recorded, the replay cannot equal the run\n", log,
               run.source().losses().unrecorded_ticks);
    return kExitDiffers;
  }
  fmt::print("{}: identical: {} ticks, {} messages\n", log, ticks, messages);
  return kExitOk;
}

void add_verify(CLI::App& app, Run& run) {
  auto log = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("verify", "Replay a recorded run and compare all that it published, byte for byte");
  command->add_option("log", *log, "Run log")->required()->type_name("RUN.lcm");
  command->callback([log, &run] { run = [log] { return verify_run(*log); }; });
}

}  // namespace hindsight::tools
