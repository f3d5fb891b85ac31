// The extension in Visual Studio Code itself, in a folder that nobody trusts.
import assert from 'node:assert';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { Editor, until } from './editor.mjs';

const flange = `%
O1001(FLANGE)
G21 G17 G40 G80 G90
T1 M6
G54 G0 X0 Y0 S2000 M3
G43 H1 Z50. M8
#1=0
WHILE[#1LT4]DO1
G1 X[1O.*#1] F300.
#1=#1+1
END1
IF[#100EQ1]GOTO90
G0 Z100. M9
IF[#101EQ1]GOTO20
G0 Z200.
N20 M5
M30
%
`;
const mark = '/started';
const shell = `#!/bin/sh\ntouch "$(dirname "$0")${mark}"\n`;

let editor;
before(async () => {
  editor = await Editor.open({
    'O1001.nc': flange,
    'maclint': shell,
    '.vscode/settings.json': '{"maclint.server.path": "./maclint"}',
  });
  await editor.openFile('O1001.nc');
  await editor.command('View: Toggle Problems');
});
after(() => editor?.close());

test('a program that is opened shows its findings, with the steps to them', async () => {
  const problems = (await until(() => editor.problems(), all => all.length > 3)).join('\n');
  assert.match(problems, /Letter O for the figure 0: '1O\.'.*at line 9/);
  assert.match(problems, /'GOTO90' finds no N90.*at line 12/);
  assert.match(problems, /there is no such sequence number at line 12/);
  assert.ok((await editor.labels('.statusbar-item')).some(each => each.includes('Fanuc macro')));
  await editor.picture('first-findings.png');
});

test('fix all mends what is safe, and the finding goes', async () => {
  await editor.command('maclint: Fix All Safe Findings');
  await until(() => editor.text(), text => text.includes('G1 X[10.*#1]'));
  await until(() => editor.problems(), all => all.every(each => !each.includes('1O.')));
});

test('a block number is renamed with the jump to it', async () => {
  await editor.goTo(16, 2);
  await editor.keys('F2');
  await editor.page.waitForFunction(() => document.activeElement?.classList.contains('rename-input'));
  await editor.keys('Control', 'a');
  await editor.page.keyboard.type('70');
  await editor.keys('Enter');
  const text = await until(() => editor.text(), all => all.includes('N70 M5'));
  assert.match(text, /IF\[#101EQ1\]GOTO70/);
});

test('what is typed is found while typing', async () => {
  await editor.goTo(17, 1);
  await editor.page.keyboard.type('#2=1/0\n');
  await until(() => editor.problems(), all => all.some(each => /Division by 0.*at line 17/.test(each)));
});

test('nothing that the folder names is started', async () => {
  await editor.command('maclint: Restart the Server');
  await until(() => editor.problems(), all => all.some(each => each.includes('GOTO90')));
  assert.ok(!existsSync(join(editor.folder, mark)));
});
