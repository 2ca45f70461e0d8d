// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/experiment_command.h"

#include <memory>

#include "tools/experiment_activity.h"
#include "tools/experiment_colours.h"
#include "tools/experiment_failsafe.h"
#include "tools/experiment_navigation.h"
#include "tools/experiment_segmentation.h"
#include "tools/experiment_slip.h"
#include "tools/experiment_traceback.h"
#include "tools/number_checks.h"

namespace hindsight::tools {
namespace {

CLI::App* add_one(CLI::App& experiments, const char* name, const char* what, std::string& course,
                  std::string& folder) {
  CLI::App* command = experiments.add_subcommand(name, what);
  command->add_option("course", course, "Course file")->required()->type_name("COURSE.toml");
  command->add_option("-o,--output", folder, "Folder for tables and figures")->required()->type_name("DIR");
  return command;
}

void add_segmentation(CLI::App& experiments, Run& run) {
  auto e = std::make_shared<SegmentationExperiment>();
  CLI::App* command =
      add_one(experiments, "segmentation",
              "Obstacle coverage with and without reverse optical flow (thesis 5.2.2)", e->course, e->folder);
  command->add_option("--drives", e->drives, "Training drives, each in a world of its own")
      ->capture_default_str()
      ->check(CLI::Range(2, 100));
  command->add_option("--bumps", e->bumps, "Trees driven into in each")
      ->capture_default_str()
      ->check(CLI::Range(1, 20));
  command->add_option("--frames", e->frames, "Labelled frames over all drives")
      ->capture_default_str()
      ->check(above_zero());
  command->add_option("--every", e->every, "Of so many frames, one is labelled")
      ->capture_default_str()
      ->check(above_zero());
  command->add_option("--seed", e->seed, "Of the first drive's world; the others follow")
      ->capture_default_str();
  command->callback([e, &run] { run = [e] { return run_segmentation_experiment(*e); }; });
}

void add_navigation(CLI::App& experiments, Run& run) {
  auto e = std::make_shared<NavigationExperiment>();
  CLI::App* command =
      add_one(experiments, "navigation",
              "Time and touches to a goal, learning off, with what the segmentation experiment's last drive "
              "taught (thesis 5.2.2); goes on where it was stopped",
              e->course, e->folder);
  command
      ->add_option("--numbers", e->numbers,
                   "Whose configuration drives: the default's, the default's without texture, or the thesis'")
      ->capture_default_str()
      ->check(CLI::IsMember({"default", "color", "thesis"}));
  command->add_option("--worlds", e->worlds, "Worlds")->capture_default_str()->check(above_zero());
  command->add_option("--starts", e->starts, "Starts in each, within 5 m")
      ->capture_default_str()
      ->check(above_zero());
  command->add_option("--seed", e->first_seed, "Of the first world; the others follow")
      ->capture_default_str();
  command->add_option("--seconds", e->seconds, "Longest run [s]")->capture_default_str()->check(above_zero());
  command->add_option("--processes", e->processes, "Runs side by side")
      ->capture_default_str()
      ->check(above_zero());
  command->callback([e, &run] { run = [e] { return run_navigation_experiment(*e); }; });
}

void add_slip(CLI::App& experiments, Run& run) {
  auto e = std::make_shared<SlipExperiment>();
  CLI::App* command =
      add_one(experiments, "slip", "How soon wheel slip is told, and how often where there is none",
              e->course, e->folder);
  command->add_option("--slips", e->slips, "At least so many")->capture_default_str()->check(above_zero());
  command->add_option("--hours", e->hours, "On ordinary ground [h]")
      ->capture_default_str()
      ->check(above_zero());
  command->add_option("--seen-hours", e->seen_hours, "Rendered, besides [h]")
      ->capture_default_str()
      ->check(above_zero());
  command->add_option("--seed", e->seed, "Of the first drive; the others follow")->capture_default_str();
  command->add_option(
      "--csv", e->recordings,
      "Recordings of motor currents, nothing known to slip, for a further column of false alarms");
  command->add_option("--rate", e->recordings_hz, "Their samples a second [Hz]")
      ->capture_default_str()
      ->check(above_zero());
  command->callback([e, &run] { run = [e] { return run_slip_experiment(*e); }; });
}

void add_failsafe(CLI::App& experiments, Run& run) {
  auto e = std::make_shared<FailsafeExperiment>();
  CLI::App* command = add_one(experiments, "failsafe", "How far the vehicle still rolls when something dies",
                              e->course, e->folder);
  command->add_option("--drives", e->drives, "For each fault, each in a world of its own")
      ->capture_default_str()
      ->check(above_zero());
  command
      ->add_option("--cruise", e->cruise_mps, "The fault comes once it has been so fast for a second [m/s]")
      ->capture_default_str()
      ->check(above_zero());
  command->add_option("--seed", e->seed, "Of the first drive; the others follow")->capture_default_str();
  command->callback([e, &run] { run = [e] { return run_failsafe_experiment(*e); }; });
}

void add_activity(CLI::App& experiments, Run& run) {
  auto e = std::make_shared<ActivityExperiment>();
  CLI::App* command = experiments.add_subcommand("activity",
                                                 "Tracking from the air with and without a learned activity "
                                                 "map, and registration by motion (thesis 3.3)");
  command->add_option("-o,--output", e->folder, "Folder for tables and figures")
      ->required()
      ->type_name("DIR");
  command->add_option("--seeds", e->seeds, "Worlds")->capture_default_str()->check(CLI::Range(2, 1000));
  command->add_option("--frames", e->frames, "Of each world's test video")
      ->capture_default_str()
      ->check(CLI::Range(20, 100000));
  command->add_option("--processes", e->processes, "Worlds side by side")
      ->capture_default_str()
      ->check(above_zero());
  command->add_option("--seed", e->seed, "Of the first world; the others follow")->capture_default_str();
  command->callback([e, &run] { run = [e] { return run_activity_experiment(*e); }; });
}

void add_traceback(CLI::App& experiments, Run& run) {
  auto e = std::make_shared<TracebackExperiment>();
  CLI::App* command =
      add_one(experiments, "traceback", "How far tracebacks end from where things were, by time and distance",
              e->course, e->folder);
  command->add_option("--frames", e->frames, "Of each drive")
      ->capture_default_str()
      ->check(CLI::Range(200, 100000));
  command->add_option("--every", e->every, "Of so many frames, one is traced back from")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  command->add_option("--seed", e->seed, "Of the world")->capture_default_str();
  command->callback([e, &run] { run = [e] { return run_traceback_experiment(*e); }; });
}

void add_colours(CLI::App& experiments, Run& run) {
  auto e = std::make_shared<ColoursExperiment>();
  CLI::App* command = experiments.add_subcommand(
      "colours", "Colours of rendered frames beside those of real labelled stills, by class");
  command->add_option("courses", e->courses, "Course files")->required()->type_name("COURSE.toml");
  command->add_option("--stills", e->stills, "Folder of NUMBER/rgb.jpg and labels.png (YCOR)")
      ->required()
      ->type_name("DIR");
  command->add_option("-o,--output", e->folder, "Folder for table and figure")->required()->type_name("DIR");
  command->add_option("--frames", e->frames, "Rendered of each course")
      ->capture_default_str()
      ->check(above_zero());
  command->add_option("--seed", e->seed, "Of the worlds")->capture_default_str();
  command->callback([e, &run] { run = [e] { return run_colours_experiment(*e); }; });
}

}  // namespace

void add_experiment(CLI::App& app, Run& run) {
  CLI::App* experiments = app.add_subcommand("experiment", "Repeat the thesis' experiments in simulation");
  experiments->require_subcommand(1);
  add_segmentation(*experiments, run);
  add_navigation(*experiments, run);
  add_traceback(*experiments, run);
  add_slip(*experiments, run);
  add_failsafe(*experiments, run);
  add_colours(*experiments, run);
  add_activity(*experiments, run);
}

}  // namespace hindsight::tools
