// `maclint lsp`: started, restarted, stopped.
'use strict';
const path = require('node:path');
const vscode = require('vscode');
const { LanguageClient, State, TransportKind } = require('vscode-languageclient/node');
const { findExecutable } = require('./executable');
const { languages } = require('./languages');

const explain = 'maclint.explain';

class Server {
  #client;

  constructor(context, output, status, pages) {
    Object.assign(this, { context, output, status, pages });
  }

  /** Says what is wrong instead of throwing: colours and languages work without a server. */
  async start() {
    const found = findExecutable({ settings: vscode.workspace.getConfiguration('maclint'), folder: this.context.extensionPath });
    if (found.problem) return this.#fail(found.problem);
    this.output.appendLine(`Starting ${found.command} lsp`);
    this.#client = new LanguageClient('maclint', 'maclint', this.#process(found.command), this.#options());
    this.#client.onDidChangeState(({ newState }) => this.status.show(newState === State.Running ? 'running' : newState === State.Starting ? 'starting' : 'stopped'));
    try {
      await this.#client.start();
    } catch (error) {
      this.#client = undefined;
      this.#fail(`${found.command} does not serve editors (${error.message}). It must know 'maclint lsp'.`);
    }
  }

  async stop() {
    const client = this.#client;
    this.#client = undefined;
    await client?.stop();
  }

  async restart() {
    await this.stop();
    await this.start();
  }

  has(command) {
    return this.#client?.initializeResult?.capabilities.executeCommandProvider?.commands.includes(command) ?? false;
  }

  /** What the server answers to one of its commands; undefined where there is no server or it has no such command. */
  async execute(command, ...args) {
    if (!this.has(command)) return undefined;
    return this.#client.sendRequest('workspace/executeCommand', { command, arguments: args });
  }

  /** Applies what the server answered as an edit. */
  async apply(edit) {
    return vscode.workspace.applyEdit(await this.#client.protocol2CodeConverter.asWorkspaceEdit(edit));
  }

  async explain(code) {
    const page = await this.execute(explain, code);
    if (page) await this.pages.show(code, page);
    return page !== undefined;
  }

  #process(command) {
    // Not in the folder that is open: Windows would look there for what a program loads.
    return { command, args: ['lsp'], transport: TransportKind.stdio, options: { cwd: path.dirname(command) } };
  }

  #options() {
    return {
      documentSelector: languages.flatMap(language => ['file', 'untitled'].map(scheme => ({ language, scheme }))),
      outputChannel: this.output,
      middleware: {
        // "Explain MAC303" among the quick fixes is a command of the server, whose answer nobody else would show.
        executeCommand: async (command, args, next) =>
          command === explain ? this.explain(args[0]) : next(command, args),
      },
    };
  }

  #fail(problem) {
    this.output.appendLine(problem);
    this.status.show('failed', problem);
    vscode.window.showErrorMessage(`maclint: ${problem}`);
  }
}

module.exports = { Server };
