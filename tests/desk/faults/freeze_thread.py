#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hindsight authors
# SPDX-License-Identifier: BSD-2-Clause
"""freeze_thread.py PID THREAD SECONDS [TIMES [PAUSE]]

Stops one thread of a process, by its name, for SECONDS, as a debugger does; the others go on. With TIMES it does so
again and again, PAUSE seconds apart. The thread of the process itself is called "main".
"""
import ctypes
import os
import sys
import time

PTRACE_CONT, PTRACE_DETACH, PTRACE_SEIZE, PTRACE_INTERRUPT = 7, 17, 0x4206, 0x4207
WALL = 0x40000000

libc = ctypes.CDLL(None, use_errno=True)
libc.ptrace.argtypes = [ctypes.c_long] * 4
libc.ptrace.restype = ctypes.c_long


def ptrace(request, thread):
    if libc.ptrace(request, thread, 0, 0) != 0:
        raise OSError(ctypes.get_errno(), f"ptrace {request:#x}")


def find(process, name):
    if name == "main":
        return process
    for thread in os.listdir(f"/proc/{process}/task"):
        with open(f"/proc/{process}/task/{thread}/comm", encoding="ascii") as comm:
            if comm.read().strip() == name:
                return int(thread)
    sys.exit(f"freeze_thread: process {process} has no thread {name}")


def hold(thread, seconds):
    """Stops the thread for a while. False if it was killed meanwhile: it vanishes only when its tracer has seen that."""
    ptrace(PTRACE_INTERRUPT, thread)
    os.waitpid(thread, WALL)
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if os.waitpid(thread, WALL | os.WNOHANG) != (0, 0):
            return False
        time.sleep(min(0.05, max(end - time.monotonic(), 0.0)))
    return True


def main():
    process, name, seconds = int(sys.argv[1]), sys.argv[2], float(sys.argv[3])
    times = int(sys.argv[4]) if len(sys.argv) > 4 else 1
    pause = float(sys.argv[5]) if len(sys.argv) > 5 else 0.0
    thread = find(process, name)
    ptrace(PTRACE_SEIZE, thread)
    for _ in range(times - 1):
        if not hold(thread, seconds):
            return
        ptrace(PTRACE_CONT, thread)
        time.sleep(pause)
    if hold(thread, seconds):
        ptrace(PTRACE_DETACH, thread)


main()
