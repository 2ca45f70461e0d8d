// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// A save is killed before and after each of its system calls; what is loaded afterwards is the old model or
// the new one.
#include "daemon/model_store.h"

#include <gtest/gtest.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>

#include "daemon/run_setup.h"
#include "daemon/saved_state.h"
#include "perception/mixture_codec.h"

namespace hindsight {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

Bytes model(int number) {
  MixtureSnapshot mixture;
  for (int i = 0; i < 8; ++i) {
    MixtureComponent component;
    component.mean = Eigen::Vector3d(10.0 * i, number, 0.0);
    component.covariance = Eigen::Matrix3d::Identity() * 9.0;
    component.weight_px = 1.0;
    mixture.components.push_back(component);
  }
  return encode_mixture(mixture);
}

void write(const fs::path& file, const Bytes& bytes) {
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

/// What a traced child did, system call by system call.
struct Trace {
  bool ended = false;        ///< by itself
  std::vector<long> called;  ///< numbers, as entered
};

/// Runs `work` in a child of its own and kills it at its stop number `kill_at`; each system call has two:
/// before it does anything, and when it is done.
Trace run_traced(const std::function<void()>& work, int kill_at) {
  const pid_t child = fork();
  if (child == 0) {
    ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
    raise(SIGSTOP);
    work();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ptrace(PTRACE_SETOPTIONS, child, nullptr, PTRACE_O_TRACESYSGOOD | PTRACE_O_EXITKILL);
  Trace trace;
  for (int stop = 0;; ++stop) {
    if (stop == kill_at) kill(child, SIGKILL);
    ptrace(PTRACE_SYSCALL, child, nullptr, nullptr);
    waitpid(child, &status, 0);
    trace.ended = WIFEXITED(status);
    if (trace.ended || WIFSIGNALED(status)) return trace;
    __ptrace_syscall_info info{};
    ptrace(PTRACE_GET_SYSCALL_INFO, child, sizeof info, &info);
    if (info.op == PTRACE_SYSCALL_INFO_ENTRY) trace.called.push_back(static_cast<long>(info.entry.nr));
  }
}

class ModelStore : public testing::Test {
 protected:
  ModelStore()
      : folder_(fs::path(testing::TempDir()) / ("hindsight_model_store_" + std::to_string(getpid()))) {
    configuration_.robot.model_file = (folder_ / "mixture.bin").string();
  }
  ~ModelStore() override { fs::remove_all(folder_); }

  fs::path file() const { return configuration_.robot.model_file; }
  Bytes loaded() const { return load_saved_mixture(configuration_); }
  void begin_anew() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }

  /// Kills a save of `fresh` at every point; `prepare` leaves what is there before. Returns how many points
  /// there were.
  int kill_everywhere(const std::function<void()>& prepare, const Bytes& fresh,
                      const std::vector<Bytes>& allowed) {
    for (int at = 0;; ++at) {
      begin_anew();
      prepare();
      const Trace trace = run_traced([&] { save_atomically(file(), fresh); }, at);
      const Bytes found = loaded();
      EXPECT_NE(std::find(allowed.begin(), allowed.end(), found), allowed.end())
          << "killed at stop " << at << ", " << found.size() << " bytes are left";
      EXPECT_EQ(save_atomically(file(), model(9)), "") << "what a killed save leaves is in nobody's way";
      EXPECT_EQ(loaded(), model(9));
      if (trace.ended || HasFailure()) return at;
    }
  }

  fs::path folder_;
  Configuration configuration_;
};

TEST_F(ModelStore, AKilledSaveLeavesTheOldModelOrTheNew) {
  const int points =
      kill_everywhere([&] { save_atomically(file(), model(1)); }, model(2), {model(1), model(2)});
  EXPECT_GE(points, 16) << "create, write, sync, link, rename, sync the folder: two stops each, and closing";
}

TEST_F(ModelStore, AKilledSaveLeavesTheOldModelOrTheNewWhereAPreviousOneIsKept) {
  const auto prepare = [&] {
    save_atomically(file(), model(0));
    save_atomically(file(), model(1));
  };
  kill_everywhere(prepare, model(2), {model(1), model(2)});
}

TEST_F(ModelStore, AKilledFirstSaveLeavesNothingOrTheNewModel) {
  kill_everywhere([] {}, model(2), {Bytes{}, model(2)});
}

/// The disk has eaten the newest copy, and the next save is killed: one of two accidents is borne at any
/// moment.
TEST_F(ModelStore, AKilledSaveOverADamagedModelLeavesAWholeOne) {
  const auto prepare = [&] {
    save_atomically(file(), model(0));
    save_atomically(file(), model(1));
    write(file(), Bytes(100, 0));
  };
  kill_everywhere(prepare, model(2), {model(0), model(2)});
}

TEST_F(ModelStore, AKilledSaveLeavesTheOldStateOrTheNew) {
  configuration_.robot.state_file = (folder_ / "state.bin").string();
  const auto state = [](double bias_radps) { return encode_state({1, bias_radps, {{1.0, 2.0, 3.0}}}); };
  for (int at = 0;; ++at) {
    begin_anew();
    save_atomically(configuration_.robot.state_file, state(0.125));
    const Trace trace =
        run_traced([&] { save_atomically(configuration_.robot.state_file, state(0.25)); }, at);
    const double bias_radps = with_saved_state(configuration_).localisation.initial_gyro_bias_radps;
    EXPECT_TRUE(bias_radps == 0.125 || bias_radps == 0.25) << "killed at stop " << at << ": " << bias_radps;
    if (trace.ended || HasFailure()) break;
  }
}

/// Against a power cut, of which a killed process shows nothing: the content is on the disk before it has the
/// name, and the name is before the save is reported.
TEST_F(ModelStore, SyncsTheContentThenRenamesThenSyncsTheFolder) {
  begin_anew();
  save_atomically(file(), model(1));
  std::vector<long> called = run_traced([&] { save_atomically(file(), model(2)); }, -1).called;
  const auto is_rename = [](long number) {
#ifdef SYS_rename
    if (number == SYS_rename) return true;
#endif
    return number == SYS_renameat || number == SYS_renameat2;
  };
  const auto rename = std::find_if(called.begin(), called.end(), is_rename);
  ASSERT_NE(rename, called.end());
  const auto written = std::find(called.begin(), rename, SYS_write);
  EXPECT_NE(std::find(written, rename, SYS_fsync), rename) << "the content";
  EXPECT_NE(std::find(rename, called.end(), SYS_fsync), called.end()) << "the folder";
}

TEST_F(ModelStore, KeepsThePreviousModel) {
  begin_anew();
  for (const int number : {1, 2, 3}) EXPECT_EQ(save_atomically(file(), model(number)), "");
  EXPECT_EQ(loaded(), model(3));
  fs::remove(file());
  EXPECT_EQ(loaded(), model(2));
}

TEST_F(ModelStore, SaysWhyItCannotSave) {
  begin_anew();
  configuration_.robot.model_file = (folder_ / "absent" / "mixture.bin").string();
  EXPECT_EQ(save_atomically(file(), model(1)),
            file().string() + ".new: cannot create: No such file or directory");
}

}  // namespace
}  // namespace hindsight
