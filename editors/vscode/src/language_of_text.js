// Endings such as .nc belong to several controls, and VS Code goes by the ending before the first line: so the text decides here.
'use strict';
const vscode = require('vscode');
const { isProgram } = require('./languages');

const linesLookedAt = 100;
// Header entries (#UNIT METRIC), sections (capital words without a number before them) and comments in brackets.
const dinplus = /^\s*(?:#\p{Lu}{2,}|\[[/ ]*\p{L}|(?!GOTO|WHILE|POPEN|PCLOS|[DB]PRNT|SETVN|PROC|EXTERN|DEFINE|LOOP|ENDLOOP|ENDFOR|ENDWHILE|ENDIF|REPEAT|UNTIL|STOPRE|MSG)\p{Lu}{4,}(?:[ _"[]|$))/u;
// Heads of programs in an archive, definitions, jumps with a direction, structures that name no number.
const sinumerik = /^\s*(?:N\d+\s*)?(?:%_N_\w+|;\$PATH=|PROC\s+[A-Z_]|EXTERN\s+[A-Z_]|DEF\s+(?:\w+\s+)?(?:INT|REAL|BOOL|CHAR|STRING|AXIS|FRAME)\b|.*\bGOTO[FB]\b|R\d+\s*=|MSG\s*\(|STOPRE\b|ENDFOR\b|ENDLOOP\b)/i;

/** 'dinplus' or 'sinumerik' where the beginning of a text shows it. */
function languageOf(text) {
  const lines = text.split(/\r\n?|\n/, linesLookedAt);
  const first = expression => lines.findIndex(line => expression.test(line));
  const [din, siemens] = [first(dinplus), first(sinumerik)];
  if (din < 0 && siemens < 0) return undefined;
  return siemens < 0 || (din >= 0 && din < siemens) ? 'dinplus' : 'sinumerik';
}

/** Once a file: who then chooses another language keeps it. */
function watchLanguages() {
  const seen = new Set();
  const look = async document => {
    const uri = document.uri.toString();
    if (!isProgram(document) || seen.has(uri)) return;
    seen.add(uri);
    if (document.languageId !== 'fanuc' || !vscode.workspace.getConfiguration('maclint', document).get('detectLanguage')) return;
    const language = languageOf(document.getText(new vscode.Range(0, 0, linesLookedAt, 0)));
    if (language) await vscode.languages.setTextDocumentLanguage(document, language);
  };
  vscode.workspace.textDocuments.forEach(look);
  return vscode.workspace.onDidOpenTextDocument(look);
}

module.exports = { languageOf, watchLanguages };
