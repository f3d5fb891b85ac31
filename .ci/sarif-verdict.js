// Reads what the SARIF Multitool found in a report and fails on everything but the rules that maclint goes without.
'use strict';
const fs = require('fs');

const goneWithout = {
  SARIF2003: 'version control details: a linter does not ask git',
  SARIF2005: 'address of the tool: as the next',
  SARIF2006: 'reachable URIs: there is no base address until the rule pages are published',
  SARIF2012: 'rule properties: help addresses need the same',
  SARIF2013: 'embedded file contents: programs are not copied into reports',
};

const log = JSON.parse(fs.readFileSync(process.argv[2], 'utf8').replace(/^\uFEFF/, ''));
const counts = new Map();
for (const run of log.runs) {
  for (const result of run.results ?? []) {
    if (result.ruleId in goneWithout) continue;
    const text = result.message.text ?? `${result.message.id}: ${(result.message.arguments ?? []).join(', ')}`;
    const entry = counts.get(result.ruleId) ?? { count: 0, example: text };
    entry.count += 1;
    counts.set(result.ruleId, entry);
  }
}
for (const [rule, { count, example }] of counts) console.log(`${rule}: ${count} times, first: ${example}`);
process.exit(counts.size === 0 ? 0 : 1);
