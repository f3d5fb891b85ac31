// The commands of package.json.
'use strict';
const vscode = require('vscode');
const { isProgram } = require('./languages');

const say = words => vscode.window.showInformationMessage(`maclint: ${words}`);

/** The document of the editor in front, or undefined after a word to the user. */
function program() {
  const editor = vscode.window.activeTextEditor;
  if (editor && isProgram(editor.document)) return editor.document;
  say('Open an NC program first.');
  return undefined;
}

const codeOf = finding => String(finding.code?.value ?? finding.code);

/** The codes of the findings at the cursor; of all in the program where there are none. */
function codesAtCursor(document) {
  const findings = vscode.languages.getDiagnostics(document.uri).filter(finding => finding.source === 'maclint');
  const cursor = vscode.window.activeTextEditor.selection.active;
  const here = findings.filter(finding => finding.range.contains(cursor));
  return [...new Set((here.length > 0 ? here : findings).map(codeOf))];
}

async function openRulePage(server) {
  const document = program();
  if (!document) return;
  const codes = codesAtCursor(document);
  if (codes.length === 0) return say('There is no finding in this program.');
  const code = codes.length === 1 ? codes[0] : await vscode.window.showQuickPick(codes, { placeHolder: 'Which rule?' });
  if (code && !await server.explain(code)) say('The server does not answer. See maclint: Show the Log.');
}

async function fixAll() {
  if (!program()) return;
  await vscode.commands.executeCommand('editor.action.codeAction', { kind: 'source.fixAll.maclint', apply: 'first' });
}

async function renumber(server) {
  const document = program();
  if (!document) return;
  if (!server.has('maclint.renumber')) return say('This maclint does not renumber from an editor. Run: maclint renumber FILE');
  try {
    const edit = await server.execute('maclint.renumber', document.uri.toString());
    if (edit) await server.apply(edit);
  } catch (error) {
    vscode.window.showErrorMessage(`maclint: ${error.message}`);
  }
}

function register(server, output) {
  const commands = {
    'maclint.openRulePage': () => openRulePage(server),
    'maclint.fixAll': fixAll,
    'maclint.renumberProgram': () => renumber(server),
    'maclint.restartServer': () => server.restart(),
    'maclint.showOutput': () => output.show(true),
  };
  return Object.entries(commands).map(([name, run]) => vscode.commands.registerCommand(name, run));
}

module.exports = { register };
