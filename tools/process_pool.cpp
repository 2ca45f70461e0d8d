// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/process_pool.h"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <vector>

#include "config/exit_code.h"
#include "drivers/unique_fd.h"

namespace hindsight::tools {
namespace {

struct Worker {
  pid_t pid = 0;
  int piece = 0;
  UniqueFd pipe;
  std::string text;
};

[[noreturn]] void work_and_exit(int out, const std::function<std::string()>& work) {
  // Several processes side by side use the cores better than threads that wait for one another.
  setenv("LP_NUM_THREADS", "1", 1);
  try {
    const std::string text = work();
    std::size_t written = 0;
    while (written < text.size()) {
      const ssize_t n = write(out, text.data() + written, text.size() - written);
      if (n <= 0) _exit(kExitIo);
      written += static_cast<std::size_t>(n);
    }
    _exit(kExitOk);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "hindsight: %s\n", error.what());
    _exit(kExitSoftware);
  }
}

Worker start(int piece, const std::function<std::string()>& work) {
  int ends[2];
  if (pipe(ends) != 0) throw FatalError(kExitSoftware, "cannot make a pipe");
  UniqueFd from(ends[0]), to(ends[1]);
  const pid_t pid = fork();
  if (pid < 0) throw FatalError(kExitSoftware, "cannot start a process");
  if (pid == 0) work_and_exit(to.get(), work);
  return {pid, piece, std::move(from), {}};
}

/// Waits for text from any of them; the worker that has ended, or none.
std::vector<Worker>::iterator wait_for_any(std::vector<Worker>& workers) {
  std::vector<pollfd> polled;
  for (const Worker& worker : workers) polled.push_back({worker.pipe.get(), POLLIN, 0});
  poll(polled.data(), polled.size(), -1);
  for (std::size_t i = 0; i < workers.size(); ++i) {
    if (polled[i].revents == 0) continue;
    char buffer[65536];
    const ssize_t n = read(polled[i].fd, buffer, sizeof buffer);
    if (n <= 0) return workers.begin() + static_cast<std::ptrdiff_t>(i);
    workers[i].text.append(buffer, static_cast<std::size_t>(n));
  }
  return workers.end();
}

bool ended_well(pid_t pid) {
  int status = 0;
  waitpid(pid, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == kExitOk;
}

}  // namespace

int run_in_processes(int count, int at_once, const std::function<std::string(int)>& work,
                     const std::function<void(int, const std::string&)>& done) {
  std::vector<Worker> workers;
  int next = 0, failed = 0;
  while (next < count || !workers.empty()) {
    for (; next < count && static_cast<int>(workers.size()) < at_once; ++next)
      workers.push_back(start(next, [&] { return work(next); }));
    const auto ended = wait_for_any(workers);
    if (ended == workers.end()) continue;
    const Worker worker = std::move(*ended);
    workers.erase(ended);
    if (ended_well(worker.pid))
      done(worker.piece, worker.text);
    else
      ++failed;
  }
  return failed;
}

}  // namespace hindsight::tools
