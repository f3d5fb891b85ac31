// The languages, by the ids that package.json contributes and the server knows.
'use strict';

const languages = ['fanuc', 'dinplus', 'sinumerik'];
const isProgram = document => languages.includes(document.languageId);

module.exports = { isProgram, languages };
