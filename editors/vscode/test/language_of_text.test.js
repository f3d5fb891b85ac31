'use strict';
const assert = require('node:assert');
const fs = require('node:fs');
const path = require('node:path');
const test = require('node:test');
const { documentOf, load, started } = require('./support/vscode_stub');

const { languageOf } = load().texts;
const corpus = process.env.MACLINT_CORPUS;

test('what only one language has tells it', () => {
  assert.strictEqual(languageOf('%shaft.nc\nPROGRAM HEAD\n'), 'dinplus');
  assert.strictEqual(languageOf('#UNIT METRIC\n'), 'dinplus');
  assert.strictEqual(languageOf('%_N_COVER_MPF\n'), 'sinumerik');
  assert.strictEqual(languageOf('N10 IF R1==2 GOTOF DONE\n'), 'sinumerik');
  assert.strictEqual(languageOf('PROC DRILL(REAL DEPTH)\n'), 'sinumerik');
  assert.strictEqual(languageOf('%\nO9100\nIF[#1EQ1]GOTO20\nWHILE[#1LT5]DO1\nEND1\nDPRNT[X#1[53]]\nM99\n%\n'), undefined);
});

test('a file is looked at once, so that another choice stays', async () => {
  const { calls } = await started();
  const document = documentOf('PROGRAM HEAD\n');
  await calls.onOpen(document);
  await calls.onOpen(document);
  assert.deepStrictEqual(calls.languages, [['file:///O1.nc', 'dinplus']]);
});

test('other files and those of another ending are left alone', async () => {
  const { calls } = await started();
  await calls.onOpen(documentOf('PROGRAM HEAD\n', 'markdown', 'a.md'));
  await calls.onOpen(documentOf('PROC A\n', 'dinplus', 'a.ncs'));
  assert.deepStrictEqual(calls.languages, []);
});

test('the setting switches it off', async () => {
  const { calls } = await started(each => { each.settings.detectLanguage = { value: false }; });
  await calls.onOpen(documentOf('PROGRAM HEAD\n'));
  assert.deepStrictEqual(calls.languages, []);
});

test('the programs of the corpus have theirs', { skip: corpus ? false : 'MACLINT_CORPUS names no folder' }, () => {
  let read = 0;
  for (const language of ['fanuc', 'dinplus', 'sinumerik'])
    for (const name of fs.readdirSync(path.join(corpus, language), { recursive: true })) {
      const ending = path.extname(name).toLowerCase();
      const wanted = { '.nc': language, '.ncs': 'dinplus' }[ending];
      if (!wanted || ending !== '.nc') continue;
      const found = languageOf(fs.readFileSync(path.join(corpus, language, name), 'utf8')) ?? 'fanuc';
      assert.strictEqual(found, wanted, name);
      read += 1;
    }
  assert.ok(read > 100, `only ${read} programs`);
});
