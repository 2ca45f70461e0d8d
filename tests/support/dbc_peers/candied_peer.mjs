// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Decodes CAN frames with candied: node candied_peer.mjs FILE.dbc, lines "decode ID HEX" on stdin (ID decimal);
// prints a line "MESSAGE SIGNAL=RAW=VALUE ..." for each.
import { readFileSync } from 'node:fs';
import { createInterface } from 'node:readline';
import candied from 'candied';

const dbc = new candied.Dbc();
const can = new candied.Can();
can.database = dbc.load(readFileSync(process.argv[2], 'utf8'));

for await (const line of createInterface({ input: process.stdin })) {
  const [, id, hex] = line.split(' ');
  const message = can.decode(can.createFrame(Number(id), [...Buffer.from(hex, 'hex')]));
  const signals = [...message.boundSignals].map(([name, s]) => `${name}=${s.rawValue}=${s.value}`);
  console.log([message.name, ...signals].join(' '));
}
