// Stands for the `vscode` module and the client library, as far as the extension uses them. It is no VS Code: npm has none.
'use strict';
const Module = require('node:module');

function makeVscode(calls) {
  const disposable = { dispose() {} };
  const vscode = {
    StatusBarAlignment: { Left: 1, Right: 2 },
    Range: class { constructor(...corners) { this.corners = corners; } },
    Uri: { from: parts => ({ ...parts, toString: () => `${parts.scheme}:${parts.path}` }) },
    window: {
      activeTextEditor: undefined,
      createOutputChannel: () => ({ lines: [], appendLine(line) { this.lines.push(line); calls.log.push(line); }, show() { calls.shown += 1; }, dispose() {} }),
      createStatusBarItem: () => (calls.status = { show() {}, dispose() {} }),
      showErrorMessage: words => { calls.errors.push(words); },
      showInformationMessage: words => { calls.told.push(words); },
      showQuickPick: async list => list[0],
    },
    workspace: {
      textDocuments: [],
      getConfiguration: () => ({
        get: name => calls.settings[name]?.value,
        inspect: name => calls.settings[name],
      }),
      onDidChangeConfiguration: run => { calls.onSettings = run; return disposable; },
      onDidOpenTextDocument: run => { calls.onOpen = run; return disposable; },
      registerTextDocumentContentProvider: (scheme, provider) => { calls.providers[scheme] = provider; return disposable; },
      applyEdit: async edit => { calls.edits.push(edit); return true; },
    },
    languages: {
      setTextDocumentLanguage: async (document, language) => { calls.languages.push([document.uri.toString(), language]); },
      getDiagnostics: () => calls.diagnostics,
    },
    commands: {
      registerCommand: (name, run) => { calls.commands[name] = run; return disposable; },
      executeCommand: async (...words) => { calls.executed.push(words); },
    },
  };
  return vscode;
}

function makeClientLibrary(calls) {
  class LanguageClient {
    constructor(id, name, process, options) {
      Object.assign(this, { process, options, initializeResult: { capabilities: { executeCommandProvider: { commands: calls.serverCommands } } } });
      this.protocol2CodeConverter = { asWorkspaceEdit: async edit => ({ converted: edit }) };
      calls.clients.push(this);
    }
    onDidChangeState(run) { this.changeState = run; }
    async start() {
      if (calls.refuses) throw new Error('no answer');
      this.changeState({ newState: 3 });
      this.changeState({ newState: 2 });
    }
    async stop() { this.stopped = true; }
    async sendRequest(method, params) {
      calls.requests.push([method, params]);
      const answer = calls.answers[params.command];
      if (answer instanceof Error) throw answer;
      return answer;
    }
  }
  return { LanguageClient, State: { Stopped: 1, Running: 2, Starting: 3 }, TransportKind: { stdio: 0 } };
}

/** Loads the extension anew with stubs; `calls` tells what it did and says what they answer. */
function load() {
  const calls = {
    log: [], errors: [], told: [], edits: [], languages: [], executed: [], requests: [], clients: [], commands: {}, providers: {}, settings: {},
    diagnostics: [], answers: {}, serverCommands: ['maclint.explain', 'maclint.renumber'], shown: 0, refuses: false,
  };
  const stubs = { vscode: makeVscode(calls), 'vscode-languageclient/node': makeClientLibrary(calls) };
  const original = Module._load;
  Module._load = (name, ...rest) => stubs[name] ?? original(name, ...rest);
  try {
    for (const key of Object.keys(require.cache)) if (key.includes('/src/')) delete require.cache[key];
    return { calls, vscode: stubs.vscode, extension: require('../../src/extension'), texts: require('../../src/language_of_text') };
  } finally {
    Module._load = original;
  }
}

/** The extension after VS Code has started it, with an executable that the user names. */
async function started(change = () => {}) {
  const loaded = load();
  loaded.calls.settings = { 'server.path': { globalValue: process.execPath }, detectLanguage: { value: true } };
  change(loaded.calls);
  loaded.context = { extensionPath: '/nowhere', subscriptions: [] };
  await loaded.extension.activate(loaded.context);
  return loaded;
}

function documentOf(text, languageId = 'fanuc', name = 'O1.nc') {
  return { uri: { toString: () => `file:///${name}` }, languageId, getText: () => text };
}

module.exports = { documentOf, load, started };
