#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hindsight authors
# SPDX-License-Identifier: BSD-2-Clause
"""listen_as_systemd.py SOCKET: stands in for systemd at $NOTIFY_SOCKET; prints each message with its monotonic time [s]."""
import os
import socket
import sys
import time

if os.path.exists(sys.argv[1]):
    os.unlink(sys.argv[1])
listener = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
listener.bind(sys.argv[1])
while True:
    message = listener.recv(4096).decode().replace("\n", " ")
    print(f"{time.monotonic():.3f} {message}", flush=True)
