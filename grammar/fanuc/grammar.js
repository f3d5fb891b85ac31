/// <reference types="tree-sitter-cli/dsl" />
// The block grammar of Fanuc Custom Macro B and its look-alikes, a superset of what any one control accepts.
// What people write and a control rejects is a node of its own, so that a rule can name it; nothing is a catch-all.
// README.md beside this file is the vocabulary.

/** A keyword in capitals or small letters. Letter by letter, because /…/i would also take U+017F for S. */
const anyCase = word => new RegExp([...word].map(letter =>
  /[A-Z]/.test(letter) ? `[${letter}${letter.toLowerCase()}]` : letter).join(''));

/** One token for a keyword, whatever its case, under one name. */
const keyword = word => alias(token(anyCase(word)), word);

/** One token for any of the words. Longest match picks ROUND before RO. */
const anyOf = words => token(choice(...words.map(anyCase)));

// Blanks inside a word that is one token. An address may be `X`, and `&F` on some lathes.
const blank = '[ \\t]*';
const digits = '([0-9]+\\.?[0-9]*|\\.[0-9]+)';
const letter = '&?[A-MP-Za-mp-z@]'; // O and N are no addresses of words: they head programs and blocks

// Precedence, high binds tighter (NCT manual 188; Fanuc: functions, multiplicative, additive, comparison).
const binds = { comparison: 3, additive: 4, multiplicative: 5, sign: 6 };

const functions = [
  'SIN', 'COS', 'TAN', 'ASIN', 'ACOS', 'SQRT', 'SQR', 'ABS', 'ROUND', 'RND', 'FIX', 'FUP', 'LN', 'EXP', 'BIN', 'BCD',
  'ADP', 'POW', 'SI', 'CO', 'TA', 'AS', 'AC', 'SQ', 'AB', 'RO', 'FI', 'FU', 'EX', 'BI', 'BC', 'AD'];

// Functions whose second operand follows a slash: ATAN[y]/[x], PRM[number]/[axis].
const slashFunctions = ['ATAN', 'ATN', 'AT', 'PRM'];

// Control words of other dialects and common misspellings. None can be the start of valid code.
const foreignKeywords = ['ELSE', 'ELSEIF', 'ELSIF', 'ENDIF', 'ENDW', 'ENDWHILE', 'THN', 'REPEAT', 'UNTIL', 'FOR', 'ENDFOR', 'NEXT', 'BREAK',
  'CONTINUE', 'RETURN', 'CALL'];

module.exports = grammar({
  name: 'fanuc',

  extras: $ => [/[ \t\x00\uFEFF]/, $.comment],

  // `ATAN[#1]/` may go on with `[#2]`, its second operand, or with `2`, a division.
  conflicts: $ => [[$.call], [$._bracketed_name, $._place]],

  rules: {
    file: $ => seq(optional($.block), repeat(seq($._end_of_block, optional($.block)))),

    // `;`, LF, CR, CRLF, and LF CR CR of paper tape.
    _end_of_block: $ => /;|\r\n?|\n\r*/,

    // A program number heads its block: behind words the letter O is an error (usually one typed for 0).
    block: $ => choice(
      repeat1($._head),
      seq(repeat($._head), choice($._program, $._content), repeat(choice($._head, $._content)), optional(alias($._last_address, $.empty_word))),
      seq(repeat($._head), alias($._last_address, $.empty_word))),

    _head: $ => choice($.tape_mark, $.skip, $.sequence_number, $.computed_sequence_number),
    _program: $ => choice($.program_number, $.computed_program_number, $.named_program),
    _content: $ => choice($._any_word, $.program_name, $.bare_value, $.stray_parenthesis, $.block_condition, $._statement),

    // A comment ends with its line even when its bracket is missing.
    comment: $ => token(prec(3, /\([^)\r\n]*\)?/)),

    // What is left of `(A (B))`: comments do not nest.
    stray_parenthesis: $ => ')',

    tape_mark: $ => '%',
    skip: $ => /\/[1-9]?/,

    program_number: $ => token(/[oO:][ \t]*[0-9]+/),
    computed_program_number: $ => seq(/[oO:]/, field('number', choice($._place, $.bracket))),
    named_program: $ => seq(/[oO:]/, field('name', $.program_name)),
    program_name: $ => /<[A-Za-z0-9 +\-._]*>/,

    sequence_number: $ => token(/[nN][ \t]*[0-9]+/),
    computed_sequence_number: $ => seq(/[nN]/, field('number', choice($._place, $.bracket))),

    // Words
    _any_word: $ => choice($.literal_word, $.word, $.comma_word, $.empty_word, $.malformed_word, $.letter_o_word),

    literal_word: $ => token(new RegExp(`${letter}${blank}[+-]?${blank}${digits}`)),

    // Two signs or two points: `X--5`, `X-4.5.`.
    malformed_word: $ => token(choice(
      new RegExp(`${letter}${blank}[+-]?${blank}[0-9]*\\.[0-9]*\\.[0-9.]*`),
      new RegExp(`${letter}${blank}[+-]${blank}[+-][+\\-]*${blank}${digits}`))),
    // The letter O for the digit: `GO1`, `MO6`. Only behind F-K, M, P, S, T and X-Z: CO, DO and RO begin words.
    letter_o_word: $ => token(new RegExp(`[F-KMPSTX-Zf-kmpstx-z]${blank}[+-]?[0-9]*\\.?[0-9]*[oO][0-9oO.]*`)),

    word: $ => choice(
      seq(field('address', alias($._address, $.address)), optional(field('incremental', $.incremental)), field('value', $._value)),
      seq(field('address', alias($._spaced_address, $.address)), field('value', $._value))),

    comma_word: $ => seq(',', choice($.literal_word, $.word)),

    // An address with nothing behind it: in the block `X Y10.`, or at its end. Glued letters (`GO1`) stay an error.
    empty_word: $ => prec(-1, alias($._spaced_address, $.address)),
    _last_address: $ => alias($._address, $.address),

    // The token takes the blanks with it so that `X Y10.` and `XY10.` differ.
    _address: $ => token(new RegExp(letter)),
    _spaced_address: $ => token(new RegExp(`${letter}[ \\t]+`)),

    // NCT: `ZI#23` is an incremental Z.
    incremental: $ => token(/[iI]/),

    _value: $ => choice($.number, $._place, $.bracket, $.call, alias($._signed_value, $.unary)),
    _signed_value: $ => seq(
      field('operator', $._sign), field('operand', choice($.number, $._place, $.bracket, $.call))),

    bare_value: $ => prec(-1, choice($.number, alias($._signed_number, $.unary))),
    _signed_number: $ => seq(field('operator', $._sign), field('operand', $.number)),

    // `[#1 LT 5] M99 P10`: Haas returns or goes on.
    block_condition: $ => prec(-1, seq('[', $._expression, ']')),

    // Statements
    _statement: $ => choice(
      $.assignment, $.goto_statement, $.if_statement, $.while_statement, $.do_statement, $.end_statement,
      $.output_statement, $.naming_statement, $.foreign_keyword),

    assignment: $ => seq(
      field('left', choice($._place, alias($._bracketed_name, $.bracket))), '=', field('right', $._expression)),
    _bracketed_name: $ => seq('[', choice($.named_variable, alias($._user_named, $.named_variable)), ']'),

    goto_statement: $ => seq(
      alias(token(/[Gg][Oo][ \t]*[Tt][Oo]/), 'GOTO'),
      field('target', choice($.number, $._place, $.bracket, alias($._signed_value, $.unary), alias($.sequence_number, $.label), alias($.program_number, $.label)))),

    if_statement: $ => prec.right(seq(
      keyword('IF'), field('condition', $._condition), optional(field('then', keyword('THEN'))), repeat(field('consequence', $._consequence)))),

    // Whatever stands behind an IF depends on it.
    _consequence: $ => choice($._head, $._content),

    while_statement: $ => prec.right(seq(
      alias(token(choice(anyCase('WHILE'), anyCase('WH'))), 'WHILE'), field('condition', $._condition), optional(field('loop', $.do_statement)))),

    do_statement: $ => seq(keyword('DO'), field('number', choice($.number, $._place, $.bracket))),
    end_statement: $ => seq(keyword('END'), field('number', choice($.number, $._place, $.bracket))),

    foreign_keyword: $ => anyOf(foreignKeywords),

    // Conditions
    _condition: $ => choice($.condition, $.compound_condition, $.unbracketed_condition),

    condition: $ => prec(2, seq('[', $._expression, ']')),

    compound_condition: $ => choice(
      prec.left(binds.multiplicative, seq(
        field('left', $._compound_operand), field('operator', alias($._and, $.operator)), field('right', $._compound_operand))),
      prec.left(binds.additive, seq(
        field('left', $._compound_operand), field('operator', alias($._or, $.operator)), field('right', $._compound_operand)))),
    _compound_operand: $ => choice($.condition, $.compound_condition),

    unbracketed_condition: $ => prec(-1, $._expression),

    // External output and names of common variables
    output_statement: $ => choice(
      keyword('POPEN'),
      keyword('PCLOS'),
      seq(choice(keyword('DPRNT'), keyword('BPRNT')), '[', repeat(choice($.output_text, $.output_variable)), ']')),
    output_text: $ => token(prec(-1, /[^#\[\]()\r\n;\x00]+/)),
    output_variable: $ => prec.right(seq(
      field('variable', $._place), optional(seq('[', field('format', $.number), ']')))),

    naming_statement: $ => seq(
      keyword('SETVN'), field('number', $.number), '[', $.variable_name, repeat(seq(',', $.variable_name)), ']'),
    variable_name: $ => /[A-Za-z_][A-Za-z0-9_]*/,

    // Variables
    _place: $ => choice($.variable, $.indirect_variable, $.double_sharp, $.named_variable, $.foreign_variable),

    // With a point only on some controls: `#30003.036`.
    variable: $ => token(/#[ \t]*[0-9]+(\.[0-9]*)?/),
    indirect_variable: $ => seq('#', field('index', $.bracket)),
    double_sharp: $ => seq('#', field('index', $._place)),
    named_variable: $ => prec.right(seq(
      field('name', $.system_name), optional(seq('[', field('index', $._expression), ']')))),
    // A name given by SETVN, only inside [ ]: `[#DEPTH]`.
    _user_named: $ => field('name', $.user_name),
    user_name: $ => token(/#[ \t]*[A-Za-z][A-Za-z0-9_]*/),
    system_name: $ => token(/#[ \t]*_[A-Za-z0-9_]+/),
    foreign_variable: $ => token(/#[ \t]*<[^>\r\n]*>/),

    // Expressions
    _expression: $ => choice($.number, $._place, $.bracket, $.call, $.unary, $.binary, $.comparison),

    number: $ => token(new RegExp(digits)),

    bracket: $ => seq('[', choice($._expression, alias($._user_named, $.named_variable)), ']'),

    call: $ => choice(
      seq(field('function', $.function), field('argument', $._argument)),
      seq(field('function', alias($._slash_function, $.function)), field('argument', $._argument)),
      prec.dynamic(1, seq(
        field('function', alias($._slash_function, $.function)), field('argument', $._argument),
        $._slash, field('divisor', $.bracket)))),
    _argument: $ => choice($.bracket, $.argument_list, $._place, $.number),
    argument_list: $ => seq('[', $._expression, repeat1(seq(',', $._expression)), ']'),
    function: $ => anyOf(functions),
    _slash_function: $ => anyOf(slashFunctions),

    unary: $ => prec(binds.sign, seq(
      field('operator', choice($._sign, alias($._not, $.operator))), field('operand', $._expression))),

    binary: $ => choice(
      prec.left(binds.multiplicative, seq(
        field('left', $._expression),
        field('operator', choice(alias('*', $.operator), alias($._slash, $.operator), alias($._and, $.operator), alias($._mod, $.operator))),
        field('right', $._expression))),
      prec.left(binds.additive, seq(
        field('left', $._expression),
        field('operator', choice($._sign, alias($._or, $.operator))),
        field('right', $._expression)))),

    comparison: $ => prec.left(binds.comparison, seq(
      field('left', $._expression),
      field('operator', choice(alias($._comparison, $.operator), $.symbolic_operator, alias('=', $.symbolic_operator))),
      field('right', $._expression))),

    _sign: $ => choice(alias('-', $.operator), alias('+', $.operator)),
    // Wins over the skip mark: `#1=5/2` divides.
    _slash: $ => token(prec(1, '/')),
    _and: $ => token(anyCase('AND')),
    _or: $ => anyOf(['OR', 'XOR']),
    _mod: $ => token(anyCase('MOD')),
    _not: $ => token(anyCase('NOT')),
    _comparison: $ => anyOf(['EQ', 'NE', 'GT', 'GE', 'LT', 'LE']),
    symbolic_operator: $ => token(choice('==', '<', '>', '<=', '>=', '=<', '=>', '<>', '!=')),
  },
});
