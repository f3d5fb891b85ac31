// Which maclint is started. Nothing of a folder has a say: neither its settings nor what lies in it.
'use strict';
const fs = require('node:fs');
const path = require('node:path');

const fileName = platform => (platform === 'win32' ? 'maclint.exe' : 'maclint');

function isFile(name) {
  try {
    return fs.statSync(name).isFile();
  } catch {
    return false;
  }
}

/** `server/win32-x64/maclint.exe` of the extension's folder, where it has one for this system. */
function bundled(folder, platform, arch) {
  const name = path.join(folder, 'server', `${platform}-${arch}`, fileName(platform));
  return isFile(name) ? name : undefined;
}

/** On the PATH, of whose entries relative ones are left out: they would lead into the folder that is open. */
function onPath(environment, platform) {
  const key = Object.keys(environment).find(name => name.toUpperCase() === 'PATH');
  return (environment[key] ?? '').split(platform === 'win32' ? ';' : ':').filter(folder => path.isAbsolute(folder))
    .map(folder => path.join(folder, fileName(platform))).find(isFile);
}

/**
 * `{command}`, or `{problem}` with words for the user.
 * `settings` is the `maclint` section: of `server.path` only the user's own value is taken, even where VS Code hands out another.
 */
function findExecutable({ settings, folder, platform = process.platform, arch = process.arch, environment = process.env }) {
  const chosen = (settings.inspect('server.path')?.globalValue ?? '').trim();
  if (chosen !== '') {
    if (!path.isAbsolute(chosen)) return { problem: `maclint.server.path is '${chosen}', which is no whole path. Write it from the root on.` };
    return isFile(chosen) ? { command: chosen } : { problem: `maclint.server.path names '${chosen}', which is no file. Correct it in your settings.` };
  }
  const command = bundled(folder, platform, arch) ?? onPath(environment, platform);
  if (command) return { command };
  return { problem: `There is no maclint for ${platform}-${arch} in the extension or on the PATH. Install it, or name it in maclint.server.path.` };
}

module.exports = { findExecutable };
