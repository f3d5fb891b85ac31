'use strict';
const assert = require('node:assert');
const test = require('node:test');
const { documentOf, started } = require('./support/vscode_stub');

const finding = (code, contains) => ({ source: 'maclint', code: { value: code }, range: { contains: () => contains } });
const edit = (vscode, document) => { vscode.window.activeTextEditor = { document, selection: { active: {} } }; };

test('the server is started outside of the folder that is open', async () => {
  const { calls } = await started();
  const { command, args, options } = calls.clients[0].process;
  assert.deepStrictEqual([command, args], [process.execPath, ['lsp']]);
  assert.ok(process.execPath.startsWith(options.cwd));
  assert.match(calls.status.text, /check/);
});

test('the server gets the three languages, saved or not', async () => {
  const { calls } = await started();
  const selector = calls.clients[0].options.documentSelector;
  assert.deepStrictEqual(new Set(selector.map(each => each.language)), new Set(['fanuc', 'dinplus', 'sinumerik']));
  assert.deepStrictEqual(new Set(selector.map(each => each.scheme)), new Set(['file', 'untitled']));
});

test('without an executable the user is told, once', async () => {
  const { calls } = await started(each => { each.settings['server.path'] = { globalValue: '/no/such' }; });
  assert.strictEqual(calls.clients.length, 0);
  assert.strictEqual(calls.errors.length, 1);
  assert.match(calls.status.text, /error/);
});

test('an executable that serves no editors is told', async () => {
  const { calls } = await started(each => { each.refuses = true; });
  assert.match(calls.errors[0], /no answer.*maclint lsp/);
});

test('all commands of package.json are registered, and no others', async () => {
  const { calls } = await started();
  const contributed = require('../package.json').contributes.commands.map(each => each.command);
  assert.deepStrictEqual(Object.keys(calls.commands).sort(), contributed.sort());
});

test('no command has a name that the client library registers for the server', async () => {
  const { calls } = await started();
  for (const name of ['maclint.explain', 'maclint.renumber']) assert.ok(!(name in calls.commands), name);
});

test('the page is that of the finding at the cursor', async () => {
  const { calls, vscode } = await started();
  edit(vscode, documentOf(''));
  calls.diagnostics = [finding('MAC501', false), finding('MAC523/G83.Q', true), { ...finding('X1', true), source: 'other' }];
  calls.answers['maclint.explain'] = { markdown: '# MAC523' };
  await calls.commands['maclint.openRulePage']();
  assert.deepStrictEqual(calls.requests, [['workspace/executeCommand', { command: 'maclint.explain', arguments: ['MAC523/G83.Q'] }]]);
  const [command, uri] = calls.executed[0];
  assert.strictEqual(command, 'markdown.showPreviewToSide');
  assert.strictEqual(calls.providers['maclint-rule'].provideTextDocumentContent(uri), '# MAC523');
});

test('the quick fix that explains shows the page, other commands go on', async () => {
  const { calls } = await started();
  calls.answers['maclint.explain'] = { markdown: '# MAC303' };
  const { executeCommand } = calls.clients[0].options.middleware;
  await executeCommand('maclint.explain', ['MAC303'], () => assert.fail('it would be asked twice'));
  assert.strictEqual(calls.executed[0][0], 'markdown.showPreviewToSide');
  assert.deepStrictEqual(await executeCommand('maclint.other', ['a'], (command, args) => [command, args]), ['maclint.other', ['a']]);
});

test('fix all asks for the server\'s own kind', async () => {
  const { calls, vscode } = await started();
  edit(vscode, documentOf(''));
  await calls.commands['maclint.fixAll']();
  assert.deepStrictEqual(calls.executed, [['editor.action.codeAction', { kind: 'source.fixAll.maclint', apply: 'first' }]]);
});

test('renumbering applies the edit that the server answers', async () => {
  const { calls, vscode } = await started();
  edit(vscode, documentOf(''));
  calls.answers['maclint.renumber'] = { changes: {} };
  await calls.commands['maclint.renumberProgram']();
  assert.deepStrictEqual(calls.requests[0][1], { command: 'maclint.renumber', arguments: ['file:///O1.nc'] });
  assert.deepStrictEqual(calls.edits, [{ converted: { changes: {} } }]);
});

test('a refusal to renumber is shown in the server\'s words', async () => {
  const { calls, vscode } = await started();
  edit(vscode, documentOf(''));
  calls.answers['maclint.renumber'] = new Error('GOTO#1 may go anywhere.');
  await calls.commands['maclint.renumberProgram']();
  assert.deepStrictEqual([calls.edits, calls.errors], [[], ['maclint: GOTO#1 may go anywhere.']]);
});

test('a server that cannot renumber is not asked', async () => {
  const { calls, vscode } = await started(each => { each.serverCommands = []; });
  edit(vscode, documentOf(''));
  await calls.commands['maclint.renumberProgram']();
  assert.deepStrictEqual(calls.requests, []);
  assert.match(calls.told[0], /maclint renumber FILE/);
});

test('commands of a program say so where there is none', async () => {
  const { calls, vscode } = await started();
  edit(vscode, documentOf('', 'python'));
  for (const name of ['openRulePage', 'fixAll', 'renumberProgram']) await calls.commands[`maclint.${name}`]();
  assert.deepStrictEqual([calls.told.length, calls.requests, calls.executed], [3, [], []]);
});

test('restart stops the old server first, and so does another path', async () => {
  const { calls } = await started();
  await calls.commands['maclint.restartServer']();
  assert.ok(calls.clients[0].stopped);
  await calls.onSettings({ affectsConfiguration: name => name === 'maclint.server.path' });
  assert.deepStrictEqual(calls.clients.map(each => each.stopped ?? false), [true, true, false]);
});

test('the server is stopped with VS Code', async () => {
  const { calls, extension } = await started();
  await extension.deactivate();
  assert.ok(calls.clients[0].stopped);
});
