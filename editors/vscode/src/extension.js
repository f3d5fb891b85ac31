// What VS Code starts when the first NC program is opened.
'use strict';
const vscode = require('vscode');
const { register } = require('./commands');
const { watchLanguages } = require('./language_of_text');
const { RulePages } = require('./rule_page');
const { Server } = require('./server');
const { Status } = require('./status');

let server;

async function activate(context) {
  const output = vscode.window.createOutputChannel('maclint');
  const status = new Status();
  const pages = new RulePages();
  server = new Server(context, output, status, pages);
  context.subscriptions.push(output, status, pages, watchLanguages(), ...register(server, output),
    vscode.workspace.onDidChangeConfiguration(change => {
      if (change.affectsConfiguration('maclint.server.path')) return server.restart();
    }));
  await server.start();
}

function deactivate() {
  return server?.stop();
}

module.exports = { activate, deactivate };
