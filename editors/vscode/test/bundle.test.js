// The bundle with the real client library, as it is packed. VS Code's own module is anything that is asked of it.
'use strict';
const assert = require('node:assert');
const fs = require('node:fs');
const Module = require('node:module');
const path = require('node:path');
const test = require('node:test');

const bundle = path.join(__dirname, '../dist/extension.js');
const anything = new Proxy(class {}, { get: (target, name) => (name === 'prototype' ? target.prototype : name === Symbol.toPrimitive ? () => '1.82.0' : anything) });

test('the bundle loads by itself', { skip: fs.existsSync(bundle) ? false : 'dist/extension.js is not built (npm run bundle)' }, () => {
  const original = Module._load;
  const asked = [];
  Module._load = (name, ...rest) => {
    if (!Module.isBuiltin(name) && name !== bundle) asked.push(name);
    return name === 'vscode' ? anything : original(name, ...rest);
  };
  try {
    assert.deepStrictEqual(Object.keys(require(bundle)).sort(), ['activate', 'deactivate']);
  } finally {
    Module._load = original;
  }
  assert.deepStrictEqual([...new Set(asked)], ['vscode'], 'all else is in it');
});
