// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/run_setup.h"

#include <filesystem>
#include <functional>
#include <span>

#include "config/configuration.h"
#include "config/exit_code.h"
#include "daemon/model_store.h"
#include "daemon/say.h"
#include "daemon/saved_state.h"
#include "perception/mixture_codec.h"
#include "sim_replay/read_file.h"

namespace hindsight {
namespace {

namespace fs = std::filesystem;

/// The parameters that name files.
std::vector<std::string*> file_parameters(Configuration& configuration) {
  return {&configuration.robot.calibration, &configuration.can_roles.dbc};
}

using Bytes = std::span<const std::uint8_t>;

/// The first whole one of what was saved under `file`, damaged ones with a warning; empty where there is none.
std::vector<std::uint8_t> whole_copy_of(const std::string& file, const std::function<std::string(Bytes)>& problem_of) {
  if (file.empty()) return {};
  for (const fs::path& candidate : saved_copies_of(file)) {
    if (!fs::exists(candidate)) continue;
    std::vector<std::uint8_t> bytes = read_file<std::vector<std::uint8_t>>(candidate);
    const std::string problem = problem_of(bytes);
    if (problem.empty()) return bytes;
    say(Severity::warning, "{}: {}; not used", candidate.string(), problem);
  }
  return {};
}

}  // namespace

std::string build_id() { return "hindsight " HINDSIGHT_VERSION ", g++ " __VERSION__; }

Configuration load_configuration(const std::vector<std::string>& files) {
  Configuration configuration;
  bool first = true;
  for (const std::string& file : files) {
    const fs::path folder = fs::absolute(file).parent_path();
    // Defaults belong to the folder of the first file; what a later file names belongs to its own.
    Configuration changed = configuration;
    for (std::string* path : file_parameters(changed)) *path = first ? *path : "";
    read_configuration(changed, ConfigDocument::load(file));
    const auto before = file_parameters(configuration);
    const auto after = file_parameters(changed);
    for (std::size_t i = 0; i < after.size(); ++i) {
      *after[i] = after[i]->empty() ? *before[i] : (folder / *after[i]).lexically_normal().string();
    }
    configuration = changed;
    first = false;
  }
  return configuration;
}

std::string to_text(Configuration configuration) { return print_configuration(configuration); }

std::vector<std::uint8_t> load_saved_mixture(const Configuration& configuration) {
  return whole_copy_of(configuration.robot.model_file, [](Bytes bytes) { return decode_mixture(bytes).problem; });
}

Configuration with_saved_state(Configuration configuration) {
  const auto bytes =
      whole_copy_of(configuration.robot.state_file, [](Bytes saved) { return decode_state(saved).problem; });
  if (bytes.empty()) return configuration;
  const SavedState state = decode_state(bytes).state;
  configuration.localisation.initial_gyro_bias_radps = state.gyro_bias_radps;
  say(Severity::notice, "the last run, saved at UNIX time {}, had a gyro bias of {:.5f} rad/s and a trajectory of {} poses",
      state.utime_us / 1'000'000, state.gyro_bias_radps, state.track.size());
  return configuration;
}

RunHeader load_materials(const Configuration& configuration) {
  RunHeader materials;
  materials.build_id = build_id();
  materials.configuration = to_text(configuration);
  materials.dbc = read_file<std::string>(configuration.can_roles.dbc);
  materials.calibration = read_file<std::string>(configuration.robot.calibration);
  materials.mixture = load_saved_mixture(configuration);
  return materials;
}

Configuration configuration_of(const RunHeader& header) {
  Configuration configuration;
  read_configuration(configuration, ConfigDocument::parse(header.configuration, "the log's configuration"));
  return configuration;
}

RobotSetup make_setup(const Configuration& configuration, const RunHeader& materials, const std::string& name) {
  const std::string prefix = name.empty() ? "" : name + ": ";
  RobotSetup setup;
  setup.configuration = configuration;
  setup.camera = parse_camera_model(materials.calibration, prefix + configuration.robot.calibration);
  setup.dbc = parse_dbc(materials.dbc, prefix + configuration.can_roles.dbc);
  if (!materials.mixture.empty()) {
    MixtureDecoded decoded = decode_mixture(materials.mixture);
    if (!decoded.problem.empty()) throw FatalError(kExitBadData, prefix + "saved mixture: " + decoded.problem);
    setup.mixture = std::move(decoded.mixture);
  }
  return setup;
}

}  // namespace hindsight
