# SPDX-FileCopyrightText: 2026 The Hindsight authors
# SPDX-License-Identifier: BSD-2-Clause
"""Decodes and encodes CAN frames with canmatrix: canmatrix_peer.py FILE.dbc, one request a line on stdin.

"decode ID HEX" (ID decimal) prints "MESSAGE SIGNAL=RAW=VALUE ..."; "encode MESSAGE SIGNAL=RAW ..." prints "ID HEX".
"""
import sys

import canmatrix.formats


def decode(matrix, frame_id, payload):
    frame = next(f for f in matrix.frames if f.arbitration_id.id == int(frame_id))
    signals = frame.decode(bytes.fromhex(payload))
    return " ".join([frame.name] + [f"{n}={s.raw_value}={float(s.phys_value)!r}" for n, s in signals.items()])


def encode(matrix, name, *signals):
    frame = matrix.frame_by_name(name)
    values = dict(signal.split("=") for signal in signals)
    return f"{frame.arbitration_id.id} {frame.encode({n: int(v) for n, v in values.items()}).hex()}"


def main():
    matrix = canmatrix.formats.loadp_flat(sys.argv[1])
    for line in sys.stdin:
        request, *arguments = line.split()
        print({"decode": decode, "encode": encode}[request](matrix, *arguments))


main()
