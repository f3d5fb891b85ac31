// The word in the status bar. A click shows the log.
'use strict';
const vscode = require('vscode');

const states = {
  starting: { text: '$(sync~spin) maclint', tip: 'maclint is starting' },
  running: { text: '$(check) maclint', tip: 'maclint reads along' },
  stopped: { text: '$(circle-slash) maclint', tip: 'maclint has stopped' },
  failed: { text: '$(error) maclint', tip: 'maclint cannot be started' },
};

class Status {
  constructor() {
    this.item = vscode.window.createStatusBarItem('maclint', vscode.StatusBarAlignment.Right, 50);
    this.item.name = 'maclint';
    this.item.command = 'maclint.showOutput';
    this.show('starting');
    this.item.show();
  }

  show(state, tip = states[state].tip) {
    this.item.text = states[state].text;
    this.item.tooltip = tip;
  }

  dispose() {
    this.item.dispose();
  }
}

module.exports = { Status };
