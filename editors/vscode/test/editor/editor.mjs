// Visual Studio Code on a folder: its server, whose extension host runs the extension, and a page in a browser.
import { execFileSync, spawn } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import puppeteer from 'puppeteer-core';

const server = join(import.meta.dirname, 'node_modules/code-server/lib/vscode/out/server-main.js');
const rest = milliseconds => new Promise(resolve => setTimeout(resolve, milliseconds));

/// Asks until the answer satisfies; fails with the last answer after a minute.
export async function until(ask, satisfies) {
  const end = Date.now() + 60_000;
  for (;;) {
    const answer = await ask();
    if (satisfies(answer)) return answer;
    if (Date.now() > end) throw new Error('after a minute there is still: ' + JSON.stringify(answer));
    await rest(200);
  }
}

export class Editor {
  /// `files`: contents by name, of the folder that is opened and not trusted.
  static async open(files) {
    const editor = new Editor();
    editor.home = mkdtempSync(join(tmpdir(), 'maclint-editor-'));
    editor.folder = join(editor.home, 'shop');
    for (const [name, text] of Object.entries(files)) {
      mkdirSync(join(editor.folder, name, '..'), { recursive: true });
      writeFileSync(join(editor.folder, name), text);
    }
    const data = join(editor.home, 'server');
    const settings = { 'maclint.server.path': process.env.MACLINT, 'workbench.startupEditor': 'none' };
    mkdirSync(join(data, 'data/Machine'), { recursive: true });
    writeFileSync(join(data, 'data/Machine/settings.json'), JSON.stringify(settings));
    const places = ['--accept-server-license-terms', '--telemetry-level', 'off', '--server-data-dir', data,
      '--extensions-dir', join(editor.home, 'extensions')];
    execFileSync(process.execPath, [server, ...places, '--install-extension', process.env.EXTENSION], { stdio: 'pipe' });
    editor.process = spawn(process.execPath,
      [server, ...places, '--host', '127.0.0.1', '--port', '0', '--without-connection-token'], { stdio: 'pipe' });
    editor.browser = await puppeteer.launch({ executablePath: process.env.BROWSER,
      args: ['--no-sandbox', '--disable-gpu'], defaultViewport: { width: 1280, height: 800 } });
    editor.page = await editor.browser.newPage();
    const port = await editor.port();
    await editor.page.goto(`http://127.0.0.1:${port}/?folder=${editor.folder}`, { waitUntil: 'domcontentloaded' });
    const dialog = await editor.page.waitForSelector('.dialog-buttons .monaco-button', { timeout: 60_000 });
    await dialog.click(); // "No, I don't trust the authors"
    await editor.page.waitForSelector('.dialog-buttons', { hidden: true });
    return editor;
  }

  port() {
    return new Promise((resolve, reject) => {
      let text = '';
      this.process.stdout.on('data', part => {
        text += part;
        const port = /listening on (\d+)/.exec(text);
        if (port) resolve(port[1]);
      });
      this.process.on('exit', () => reject(new Error('the editor has ended: ' + text)));
    });
  }

  async close() {
    await this.browser?.close();
    this.process?.removeAllListeners('exit').kill();
    rmSync(this.home, { recursive: true, force: true, maxRetries: 5 });
  }

  async openFile(name) {
    await until(() => this.labels('.explorer-folders-view .monaco-list-row'), names => names.some(each => each.startsWith(name)));
    for (const row of await this.page.$$('.explorer-folders-view .monaco-list-row'))
      if ((await row.evaluate(each => each.textContent)).startsWith(name)) await row.click({ count: 2 });
    await this.page.waitForSelector('.monaco-editor .view-line');
  }

  labels(selector) {
    return this.page.$$eval(selector, all => all.map(each => each.getAttribute('aria-label') || each.textContent));
  }

  /// What the list of problems shows.
  problems() {
    return this.labels('.markers-panel .monaco-list-row');
  }

  /// The text that the editor shows.
  async text() {
    const lines = await this.page.$$eval('.editor-instance .view-line',
      all => all.map(each => [parseFloat(each.style.top), each.textContent.replaceAll('\u00a0', ' ')]));
    return lines.sort((one, other) => one[0] - other[0]).map(each => each[1]).join('\n');
  }

  async keys(...names) {
    for (const name of names) await this.page.keyboard.down(name);
    for (const name of names.reverse()) await this.page.keyboard.up(name);
  }

  async command(name) {
    await this.keys('F1');
    await this.page.waitForSelector('.quick-input-widget input');
    await this.page.keyboard.type(name);
    await until(() => this.labels('.quick-input-list .monaco-list-row'), rows => rows.length > 0 && rows[0].includes(name));
    await this.keys('Enter');
  }

  async goTo(line, column) {
    await this.command('View: Focus Active Editor Group');
    await this.keys('Control', 'g');
    await this.page.waitForSelector('.quick-input-widget input');
    await this.page.keyboard.type(`${line},${column}`);
    await this.keys('Enter');
    await until(() => this.labels('.statusbar-item'), items => items.some(each => each.includes(`Ln ${line}, Col ${column}`)));
  }

  picture(name) {
    return this.page.screenshot({ path: name });
  }
}
