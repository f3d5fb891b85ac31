/// <reference types="tree-sitter-cli/dsl" />
// The block grammar of HEIDENHAIN DIN PLUS (CNC PILOT 640, MANUALplus 620), a superset of what the control accepts.
// What people write and a control rejects is a node of its own, so that a rule can name it; nothing is a catch-all.
// Section words are known by their shape only: the table of real ones lives with the dialect.
// README.md beside this file is the vocabulary.
//
// No token has a precedence: in tree-sitter it would beat a longer match (`ENDIFX` as ENDIF and X). The longest match
// wins, and among equals the one that stands first in this file: keywords before addresses before capital words.

/** A keyword in capitals or small letters. Letter by letter, because /…/i would also take U+017F for S. */
const anyCase = word => new RegExp([...word].map(letter =>
  /[A-Z]/.test(letter) ? `[${letter}${letter.toLowerCase()}]` : letter).join(''));

/** One token for a keyword, whatever its case, under one name. */
const keyword = word => alias(token(anyCase(word)), word);

/** One token for any of the words. */
const anyOf = words => token(choice(...words.map(anyCase)));

/** Words of one rule and commas between them. */
const listOf = rule => seq(rule, repeat(seq(',', rule)));

// Blanks inside a word that is one token.
const blank = '[ \\t]*';
const digits = '([0-9]+\\.?[0-9]*|\\.[0-9]+)';

// An address: one or two capitals, and HID. N alone heads a block and L alone calls. IF, OR and the comparisons EQ, GE,
// GT and LT are no addresses, and NE and LE are two only when their number touches them: `IF 1==#l1` holds no word
// `IF 1`, `IF #l1 NE 5` no word `NE 5`.
const otherPairs = '[A-DFHJKMP-Z][A-Z]|E[A-PR-Z]|G[A-DF-SU-Z]|I[A-EG-Z]|O[A-QS-Z]|HID';
const spacedPairs = `${otherPairs}|N[A-DF-Z]|L[A-DF-SU-Z]`;
const pairs = `${otherPairs}|N[A-Z]|L[A-SU-Z]`;
const letters = `([A-KMO-Z]|${pairs})`;
const beforeNumber = `(([A-MO-Z]|${pairs})i?|([A-MO-Z]|${spacedPairs})i?[ \\t]+)`;
const signed = `([+-]${blank})?${digits}`;
const smallLetters = '([a-mo-z]|[a-hj-np-z][a-z]|i[a-eg-z]|o[a-qs-z])';

// A capital of a section word. What is not ASCII counts, for files in Latin-1 come undecoded (`#TYÖKAPPALE`);
// typographic quotes (U+2000 ...) do not. U+0001 is in, because tree-sitter hands out such bytes as -1 and compares.
const capital = '[^\\x02-@\\[-\\u00BF\\u2000-\\u206F\\uFEFF]';
const small = '[^\\x02-\\x60{-\\u00BF\\u2000-\\u206F\\uFEFF]';
const capitals = `[A-Z]${capital}${capital}+(_${capital}+)*`;

// Precedence of operators, high binds tighter (manual 6.31 and 6.33; conditions are linked comparisons).
const binds = { or: 1, and: 2, comparison: 3, additive: 4, multiplicative: 5, sign: 6 };

const functions = [
  'SIN', 'COS', 'TAN', 'ASIN', 'ACOS', 'ATAN', 'ABS', 'ROUND', 'INT', 'SQRT', 'SQRTA', 'SQRTS', 'LOGN', 'EXP', 'BITSET', 'STRING', 'PARA',
  'PARAM', 'TIME'];

// Comparisons of other languages.
const foreignOperators = ['EQ', 'NE', 'GT', 'GE', 'LT', 'LE'].map(anyCase).concat(['=<', '=>', '!=', '><']);

module.exports = grammar({
  name: 'dinplus',

  extras: $ => [/[ \t\uFEFF]/, $.comment, $.unclosed_comment, $.description_mark, $.foreign_comment],

  rules: {
    file: $ => seq(optional($._line), repeat(seq($._end_of_line, optional($._line)))),

    _end_of_line: $ => /\r\n?|\n\r*/,

    _line: $ => choice($.program_name_line, $.header_entry, $.section, $.block),

    // `[//]` encloses the descriptions of a subprogram's transfer values.
    description_mark: $ => '[//]',
    // A comment may span lines. One that is never closed takes all that is left.
    comment: $ => /\[[^\]]*\]/,
    unclosed_comment: $ => /\[[^\]]*/,
    // Of other languages.
    foreign_comment: $ => /(;|\/\/)[^\r\n\[]*/,
    _parenthesis_comment: $ => token(seq('(', /[ \t]*[A-Za-z][^()\r\n#]*/, ')')),

    // Lines of their own
    program_name_line: $ => seq('%', optional(field('name', $.program_name)), optional(field('version', $._text))),
    program_name: $ => token.immediate(/[^ \t\r\n"\[\u201C-\u201E]([^\r\n"\[\u201C-\u201E]*[^ \t\r\n"\[\u201C-\u201E])?/),

    header_entry: $ => seq(field('name', $.header_name), optional(field('value', $.header_value))),
    // Abbreviations belong together: `#CLAMP. PRESS.` is one name. `#G20` is a variable.
    header_name: $ => token(new RegExp(`#[A-Z]${capital}+(_${capital}+)*(\\.[ \\t]*${capital}+\\.)*`)),
    header_value: $ => token.immediate(/[ \t:=][ \t]*[^ \t\r\n\[]([^\r\n\[]*[^ \t\r\n\[])?/),

    section: $ => prec.right(1, seq(
      field('name', $.section_name), optional(field('axis', alias($._address, $.axis))), repeat(field('parameter', $._section_parameter)))),
    // Manuals also print one capital and small letters (`Paluu`), never in more than one word.
    section_name: $ => prec.right(1, choice(seq($._capitals, repeat($._capitals)), $._capitalized)),
    _section_parameter: $ => prec(-1, choice($._any_word, $.number, $.slide, $._text)),

    // Blocks. A block number behind words begins the next block, whose line end was lost.
    block: $ => choice(
      repeat1($._head),
      seq(repeat($._head), $._content, repeat(choice($._content, $.block_number)))),

    _head: $ => choice($.slide, $.skip, $.block_number, $.computed_block_number, alias($._parenthesis_comment, $.foreign_comment)),
    slide: $ => /\$[0-9]+/,
    skip: $ => /\/[0-9]*/,
    block_number: $ => /[Nn][ \t]*[0-9]+/,
    computed_block_number: $ => seq('N', field('number', choice($._place, $.parenthesis))),

    _content: $ => choice($._any_word, $.bare_value, $.stray_parenthesis, $.stray_bracket, $._statement),

    bare_value: $ => prec(-1, choice($.number, $._text)),
    stray_parenthesis: $ => ')',
    stray_bracket: $ => ']',

    // Statements
    _statement: $ => choice(
      $.assignment, $.declaration, $.call,
      $.if_statement, $.then_statement, $.else_statement, $.endif_statement,
      $.while_statement, $.endwhile_statement,
      $.switch_statement, $.case_statement, $.default_statement, $.break_statement, $.endswitch_statement,
      $.return_statement, $.output_statement,
      $.unit_start, $.unit_end, $.group_start, $.group_end, $.unknown_statement),

    assignment: $ => seq(
      field('left', $._target), field('operator', choice('=', alias('==', $.equality_sign))), field('right', $._expression)),
    // A name alone, in VAR and CONST.
    declaration: $ => prec(-1, field('name', $._target)),
    _target: $ => choice($._place, $._name),

    call: $ => prec.right(seq('L', field('name', choice($._text, $._place)), repeat(field('argument', $._any_word)))),

    if_statement: $ => seq(keyword('IF'), field('condition', $._expression)),
    then_statement: $ => keyword('THEN'),
    else_statement: $ => keyword('ELSE'),
    endif_statement: $ => keyword('ENDIF'),
    while_statement: $ => seq(keyword('WHILE'), field('condition', $._expression)),
    endwhile_statement: $ => keyword('ENDWHILE'),
    switch_statement: $ => seq(keyword('SWITCH'), field('value', $._expression)),
    case_statement: $ => seq(keyword('CASE'), field('value', $._expression)),
    default_statement: $ => keyword('DEFAULT'),
    break_statement: $ => keyword('BREAK'),
    endswitch_statement: $ => keyword('ENDSWITCH'),
    return_statement: $ => prec.right(seq(keyword('RETURN'), optional(field('value', $._expression)))),

    output_statement: $ => seq(
      field('function', choice(keyword('PRINT'), keyword('INPUT'), keyword('WINDOW'))), field('arguments', $.argument_list)),

    unit_start: $ => prec.right(seq(keyword('UNIT'), repeat(field('parameter', $._any_word)))),
    unit_end: $ => prec.right(seq(keyword('END_OF_UNIT'), optional(field('check', $.number)))),
    group_start: $ => prec.right(seq(keyword('BLOCKSTART'), optional(field('name', $._text)))),
    group_end: $ => keyword('BLOCKEND'),

    // A capital word that is no keyword, and its value: `THN`, `UNTIL #l1>5`, `PRNT("A",#l1)`.
    unknown_statement: $ => prec.right(seq(
      field('keyword', alias($._capitals, $.unknown_keyword)),
      optional(field('value', choice($._expression, alias($._several, $.argument_list)))))),
    _several: $ => seq('(', optional(seq($._expression, repeat1(seq(',', $._expression)))), ')'),

    // Expressions
    _expression: $ => choice($._value, $.comparison, $.logical),

    _value: $ => choice(
      $.number, $._text, $._place, $._name, $.parenthesis, $.function_call, $.vacancy_test, $.unary, $.binary),

    parenthesis: $ => seq('(', $._expression, ')'),

    function_call: $ => seq(field('function', choice($.function, alias($._capitals, $.unknown_function))), field('arguments', $.argument_list)),
    argument_list: $ => seq('(', optional(listOf($._expression)), ')'),
    function: $ => anyOf(functions),

    // The name stands without its sign: `NDEF(__la)`, `NDEF(l1)`.
    vacancy_test: $ => seq(
      field('function', alias($._vacancy, $.function)), '(',
      field('argument', choice($._place, $._name, alias($._signless_variable, $.variable), alias($._signless_selected, $.selected_variable))), ')'),
    _vacancy: $ => anyOf(['DEF', 'NDEF', 'DVDEF']),
    _signless_variable: $ => /[A-Za-z][0-9]+/,
    _signless_selected: $ => seq(field('variable', alias($._signless_variable, $.variable)), field('selectors', $.selector_list)),

    unary: $ => prec(binds.sign, seq(field('operator', $._sign), field('operand', $._value))),

    binary: $ => choice(
      prec.left(binds.multiplicative, seq(field('left', $._value), field('operator', $._multiply), field('right', $._value))),
      prec.left(binds.additive, seq(field('left', $._value), field('operator', $._sign), field('right', $._value)))),

    // A chain (`1<#l1<5`) hangs on the left.
    comparison: $ => prec.left(binds.comparison, seq(
      field('left', choice($._value, $.comparison)),
      field('operator', choice(alias($._comparison, $.operator), alias('==', $.operator), alias('=', $.assignment_sign), $.foreign_operator)),
      field('right', $._value))),

    logical: $ => choice(
      prec.left(binds.and, seq(field('left', $._expression), field('operator', alias($._and, $.operator)), field('right', $._expression))),
      prec.left(binds.or, seq(field('left', $._expression), field('operator', alias($._or, $.operator)), field('right', $._expression)))),

    _sign: $ => choice(alias('-', $.operator), alias('+', $.operator)),
    _multiply: $ => choice(alias('*', $.operator), alias('/', $.operator)),
    _and: $ => token(anyCase('AND')),
    _or: $ => token(anyCase('OR')),
    _comparison: $ => token(choice('<>', '<', '<=', '>', '>=')),
    foreign_operator: $ => token(choice(...foreignOperators)),

    number: $ => token(new RegExp(digits)),

    // Variables
    _place: $ => choice(
      $.variable, $.selected_variable, $.indirect_variable, $.named_variable, $.transfer_variable, $.double_sharp, $.foreign_variable),
    _name: $ => choice($.constant, $.internal_constant),

    variable: $ => /#[ \t]*[A-Za-z][0-9]+/,
    selected_variable: $ => seq(field('variable', $.variable), field('selectors', $.selector_list)),
    indirect_variable: $ => prec.right(seq(
      field('kind', $.variable_kind), field('number', $.selector_list), optional(field('selectors', $.selector_list)))),
    variable_kind: $ => /#[ \t]*[A-Za-z]/,
    named_variable: $ => /#[ \t]*_[A-Za-z0-9][A-Za-z0-9_]*/,
    transfer_variable: $ => /#[ \t]*__[A-Za-z0-9_]*/,
    double_sharp: $ => seq('#', field('place', $._place)),
    // `#101`: there is no such kind. Often the letter l typed as a digit.
    foreign_variable: $ => /#[ \t]*[0-9]+/,
    constant: $ => /_[A-Za-z0-9][A-Za-z0-9_]*/,
    internal_constant: $ => /__[A-Za-z0-9_]*/,

    selector_list: $ => seq('(', listOf($._selector), ')'),
    _selector: $ => choice($._expression, $.selector, alias($._capitals, $.selector)),

    // Texts. Two quotes that a word processor made curly are a node of their own.
    _text: $ => choice($.string, $.unclosed_string, $.typographic_string),
    string: $ => /"[^"\r\n]*"/,
    unclosed_string: $ => /"[^"\r\n]*/,
    typographic_string: $ => /[\u201C-\u201E][^\u201C-\u201E"\r\n]*[\u201C-\u201E"]/,

    // Words
    _any_word: $ => choice(
      seq($.literal_word, optional(alias($._parenthesis_comment, $.foreign_comment))),
      $.extended_word, $.word, $.empty_word, $.malformed_word, $.letter_o_word, $.lower_case_word),

    // The letter O for the digit: `GO`, `MO8`.
    letter_o_word: $ => /[GMT][0-9]*O[0-9O.]*/,

    // Address, perhaps `i`, and a literal number.
    literal_word: $ => token(new RegExp(`${beforeNumber}${signed}`)),
    lower_case_word: $ => token(new RegExp(`${smallLetters}${signed}`)),

    // Two signs, two points, or a decimal comma.
    malformed_word: $ => token(choice(
      new RegExp(`${beforeNumber}([+-]${blank})?[0-9]*\\.[0-9]*\\.[0-9.]*`),
      new RegExp(`${beforeNumber}([+-]${blank})?[0-9]+,[0-9]+`),
      new RegExp(`${beforeNumber}[+-]${blank}[+-][+\\-]*${blank}${digits}`))),
    // A literal word that goes on: `X100+_sd`. The literal word is the leftmost leaf of its value.
    extended_word: $ => field('value', alias($._extended, $.binary)),
    _extended: $ => choice(
      prec.left(binds.multiplicative, seq(field('left', $._extended_left), field('operator', $._multiply), field('right', $._value))),
      prec.left(binds.additive, seq(field('left', $._extended_left), field('operator', $._sign), field('right', $._value)))),
    _extended_left: $ => choice($.literal_word, alias($._extended, $.binary)),

    word: $ => seq(
      field('address', alias($._address, $.address)),
      optional(field('incremental', $.incremental)),
      field('value', choice($._value, $.unknown_coordinate))),
    empty_word: $ => prec(-1, seq(field('address', alias($._address, $.address)), optional(field('incremental', $.incremental)))),

    incremental: $ => token.immediate('i'),
    unknown_coordinate: $ => /\?[<>]?/,

    _address: $ => token(new RegExp(letters)),
    _capitalized: $ => token(new RegExp(`[A-Z]${small}${small}${small}+`)),
    _capitals: $ => token(new RegExp(capitals)),
    selector: $ => /[A-Za-z][A-Za-z0-9]*/,
  },
});
