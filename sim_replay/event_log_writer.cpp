// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/event_log_writer.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "config/exit_code.h"
#include "sim_replay/event_log_format.h"

namespace hindsight {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{4} << 20;

/// 0, or the errno of the write that failed.
int write_all(int descriptor, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return written < 0 ? errno : EIO;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return 0;
}

}  // namespace

EventLogWriter::EventLogWriter(const std::filesystem::path& path)
    : descriptor_(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644)) {
  if (descriptor_ < 0) {
    throw FatalError(kExitIo,
                     fmt::format("{}: cannot create the log: {}", path.string(), std::strerror(errno)));
  }
  block_.reserve(kBufferBytes);
}

EventLogWriter::~EventLogWriter() { close(); }

std::span<std::uint8_t> EventLogWriter::append(std::string_view channel, std::int64_t time_us,
                                               std::size_t size) {
  if (channel.empty() || channel.size() > kMaxChannelLength || size > kMaxEventBytes) fail(EMSGSIZE);
  if (block_.bytes().size() >= kBufferBytes) flush();
  if (!ok()) return {};
  return block_.append(channel, time_us, size);
}

bool EventLogWriter::append_whole(std::span<const std::uint8_t> events) {
  if (!flush()) return false;
  const int error = write_all(descriptor_, events);
  if (error != 0) fail(error);
  flushed_bytes_ += ok() ? events.size() : 0;
  return ok();
}

bool EventLogWriter::flush() {
  if (!ok()) return false;
  const int error = write_all(descriptor_, block_.bytes());
  if (error != 0) {
    fail(error);
    return false;
  }
  flushed_bytes_ += block_.bytes().size();
  block_.clear();
  return true;
}

bool EventLogWriter::close(bool wait_for_disk) {
  if (descriptor_ < 0) return ok();
  flush();
  // Not everything that can be written to can be synchronised (EINVAL: a pipe, /dev/null).
  if (wait_for_disk && ok() && ::fdatasync(descriptor_) != 0 && errno != EINVAL) fail(errno);
  if (::close(descriptor_) != 0 && ok()) error_code_ = errno;
  descriptor_ = -1;
  return ok();
}

void EventLogWriter::fail(int error_code) {
  if (!ok()) return;
  error_code_ = error_code;
  block_.clear();
  // Half an event at the end would make a whole log a damaged one. Where cutting fails, the reader reports
  // it.
  [[maybe_unused]] const int ignored = ::ftruncate(descriptor_, static_cast<off_t>(flushed_bytes_));
}

}  // namespace hindsight
