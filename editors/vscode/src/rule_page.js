// Pages of rules, in Markdown as the server answers them, in VS Code's own preview.
'use strict';
const vscode = require('vscode');

const scheme = 'maclint-rule';

class RulePages {
  #pages = new Map();
  #registration;

  constructor() {
    this.#registration = vscode.workspace.registerTextDocumentContentProvider(scheme, {
      provideTextDocumentContent: uri => this.#pages.get(uri.path) ?? '',
    });
  }

  /** `page` is `{markdown}`. A key such as MAC523/G83.Q is no folder of the address. */
  async show(code, page) {
    const name = `/${code.replaceAll('/', ' ')}.md`;
    this.#pages.set(name, page.markdown);
    await vscode.commands.executeCommand('markdown.showPreviewToSide', vscode.Uri.from({ scheme, path: name }));
  }

  dispose() {
    this.#registration.dispose();
  }
}

module.exports = { RulePages };
