'use strict';
const assert = require('node:assert');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const test = require('node:test');
const { findExecutable } = require('../src/executable');

const settingsOf = inspected => ({ inspect: () => inspected });
const none = settingsOf(undefined);

function folderWith(t, ...names) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'maclint-'));
  t.after(() => fs.rmSync(folder, { recursive: true }));
  for (const name of names) {
    fs.mkdirSync(path.dirname(path.join(folder, name)), { recursive: true });
    fs.writeFileSync(path.join(folder, name), '');
  }
  return folder;
}

test('the settings of a folder start nothing', () => {
  const settings = settingsOf({ workspaceValue: process.execPath, workspaceFolderValue: process.execPath, defaultValue: '' });
  assert.match(findExecutable({ settings, folder: '/nowhere', environment: {} }).problem, /There is no maclint/);
});

test('the setting cannot be made in a folder', () => {
  const { contributes } = require('../package.json');
  assert.strictEqual(contributes.configuration.properties['maclint.server.path'].scope, 'machine');
});

test('the path in the user\'s settings comes first', t => {
  const folder = folderWith(t, 'server/linux-x64/maclint', 'mine/maclint');
  const chosen = path.join(folder, 'mine/maclint');
  assert.strictEqual(findExecutable({ settings: settingsOf({ globalValue: ` ${chosen} ` }), folder, platform: 'linux', arch: 'x64' }).command, chosen);
});

test('a path that is not whole, or names nothing, is told', () => {
  assert.match(findExecutable({ settings: settingsOf({ globalValue: 'maclint' }), folder: '/' }).problem, /'maclint', which is no whole path/);
  assert.match(findExecutable({ settings: settingsOf({ globalValue: '/no/such' }), folder: '/' }).problem, /'\/no\/such', which is no file/);
});

test('the bundled one is that of the system', t => {
  const folder = folderWith(t, 'server/linux-x64/maclint', 'server/win32-x64/maclint.exe');
  const found = (platform, arch) => findExecutable({ settings: none, folder, platform, arch, environment: {} });
  assert.strictEqual(found('linux', 'x64').command, path.join(folder, 'server/linux-x64/maclint'));
  assert.strictEqual(found('win32', 'x64').command, path.join(folder, 'server/win32-x64/maclint.exe'));
  assert.match(found('darwin', 'arm64').problem, /darwin-arm64/);
});

test('the PATH comes last, without its relative entries', t => {
  const folder = folderWith(t, 'bin/maclint');
  const before = process.cwd();
  process.chdir(folder);
  t.after(() => process.chdir(before));
  const found = entries => findExecutable({ settings: none, folder: '/nowhere', platform: 'linux', arch: 'x64', environment: { Path: entries } });
  assert.strictEqual(found(`.:bin:${folder}/bin`).command, path.join(folder, 'bin/maclint'));
  assert.match(found('.:bin:').problem, /There is no maclint/);
});
