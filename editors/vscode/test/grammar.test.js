// Colours, by the library that VS Code itself colours with.
'use strict';
const assert = require('node:assert');
const fs = require('node:fs');
const path = require('node:path');
const test = require('node:test');
const textmate = require('vscode-textmate');
const oniguruma = require('vscode-oniguruma');

const root = path.join(__dirname, '..');
const { grammars, languages } = require('../package.json').contributes;

let registry;
test.before(async () => {
  await oniguruma.loadWASM(fs.readFileSync(require.resolve('vscode-oniguruma/release/onig.wasm')).buffer);
  registry = new textmate.Registry({
    onigLib: Promise.resolve({ createOnigScanner: list => new oniguruma.OnigScanner(list), createOnigString: text => new oniguruma.OnigString(text) }),
    loadGrammar: async scope => {
      const { path: file } = grammars.find(each => each.scopeName === scope);
      return textmate.parseRawGrammar(fs.readFileSync(path.join(root, file), 'utf8'), file);
    },
  });
});

/** `{text: innermost scope without the language}` of the lines; what has no scope is left out. */
async function scopesOf(language, ...lines) {
  const grammar = await registry.loadGrammar(`source.${language}`);
  const found = {};
  let stack = textmate.INITIAL;
  for (const line of lines) {
    const { tokens, ruleStack } = grammar.tokenizeLine(line, stack);
    stack = ruleStack;
    for (const { startIndex, endIndex, scopes } of tokens)
      if (scopes.length > 1) found[line.slice(startIndex, endIndex).trim()] = scopes.at(-1).replace(`.${language}`, '');
  }
  return found;
}

test('Fanuc', async () => {
  const scopes = await scopesOf('fanuc', 'O9100(BORE)', '%O9601', '/2 N10 IF[#100EQ1]GOTO20', 'WHILE[#1LT5]DO1', 'G65 P9200 A#3 F-1.5', '#2=SQRT[#[#4]]', 'M99 (OPEN');
  const wanted = {
    O9100: 'entity.name.function.program', O9601: 'entity.name.function.program', '(BORE)': 'comment.block', '/2': 'keyword.operator.skip', N10: 'entity.name.label', IF: 'keyword.control',
    '#100': 'variable.other', EQ: 'keyword.operator.word', GOTO: 'keyword.control', 20: 'entity.name.label', WHILE: 'keyword.control', DO: 'keyword.control',
    G65: 'support.function.gcode', P: 'variable.parameter.address', 9200: 'constant.numeric', A: 'variable.parameter.address', '#3': 'variable.other',
    '-1.5': 'constant.numeric', SQRT: 'support.function', '#': 'variable.other.indirect', M99: 'support.function.mcode', '(OPEN': 'comment.block',
  };
  for (const [text, scope] of Object.entries(wanted)) assert.strictEqual(scopes[text], scope, text);
});

test('DIN PLUS', async () => {
  const scopes = await scopesOf('dinplus', '%shaft.nc', 'PROGRAM HEAD', '  SUBPROGRAM "BORE"', '#UNIT METRIC', '[TWO', 'LINES]', 'N10 L"CHAMFER" LA40', 'N11 IF #l1 > 5',
    'N12 G1 X#__la Zi-2.5', 'ENDIF');
  const wanted = {
    '%shaft.nc': 'entity.name.function.program', 'PROGRAM HEAD': 'storage.type.section', SUBPROGRAM: 'storage.type.section', '#UNIT': 'keyword.other.header', METRIC: 'string.unquoted',
    LINES: 'comment.block', N10: 'entity.name.label', L: 'keyword.control.call', '"CHAMFER"': 'entity.name.function.call', LA: 'variable.parameter.address',
    40: 'constant.numeric', IF: 'keyword.control', '#l1': 'variable.other', G1: 'support.function.gcode', '#__la': 'variable.parameter.transfer',
    Zi: 'variable.parameter.address', '-2.5': 'constant.numeric', ENDIF: 'keyword.control',
  };
  for (const [text, scope] of Object.entries(wanted)) assert.strictEqual(scopes[text], scope, text);
});

test('SINUMERIK', async () => {
  const scopes = await scopesOf('sinumerik', '%_N_COVER_MPF', 'PROC DRILL(REAL DEPTH) SAVE ;BORES', 'DEF INT ROWS=3', 'N10 G0 X5 Y=R1', 'START: MSG("GO")',
    'IF $AA_IM[X]<R2 GOTOF DONE', 'CYCLE81(5,0)', 'L20', "R7='HFF' OR 3", 'ENDIF');
  const wanted = {
    '%_N_COVER_MPF': 'entity.name.function.program', PROC: 'storage.type.function', DRILL: 'entity.name.function', REAL: 'storage.type', SAVE: 'storage.type.function',
    ';BORES': 'comment.line.semicolon', DEF: 'storage.modifier', INT: 'storage.type', N10: 'entity.name.label', G0: 'support.function.gcode',
    X: 'variable.parameter.address', 5: 'constant.numeric', Y: 'variable.parameter.address', R1: 'variable.other.r_parameter', 'START:': 'entity.name.label',
    MSG: 'entity.name.function.call', '"GO"': 'string.quoted.double', IF: 'keyword.control', $AA_IM: 'variable.language.system', GOTOF: 'keyword.control',
    DONE: 'entity.name.label', CYCLE81: 'entity.name.function.call', L20: 'entity.name.function.call', "'HFF'": 'constant.numeric.based',
    OR: 'keyword.operator.word', ENDIF: 'keyword.control',
  };
  for (const [text, scope] of Object.entries(wanted)) assert.strictEqual(scopes[text], scope, text);
});

test('every language has colours, brackets and comments', () => {
  assert.deepStrictEqual(grammars.map(each => each.language), languages.map(each => each.id));
  for (const { configuration } of languages) {
    const { comments, folding, wordPattern } = JSON.parse(fs.readFileSync(path.join(root, configuration), 'utf8'));
    assert.ok(comments && new RegExp(wordPattern) && new RegExp(folding.markers.start) && new RegExp(folding.markers.end), configuration);
  }
});

test('folding markers pair loops', () => {
  const { markers } = JSON.parse(fs.readFileSync(path.join(root, 'languages/fanuc.json'), 'utf8')).folding;
  assert.match('N5 WHILE[#1LT5]DO1', new RegExp(markers.start));
  assert.match('N10 END1', new RegExp(markers.end));
  assert.doesNotMatch('(DO 1)', new RegExp(markers.start));
  assert.doesNotMatch('GOTO10', new RegExp(markers.end));
});
