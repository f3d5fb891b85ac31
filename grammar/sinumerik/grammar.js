/// <reference types="tree-sitter-cli/dsl" />
// The block grammar of the SINUMERIK language (808D, 828D, 840D sl, ONE), a superset of what any one control accepts.
// What people write and a control rejects is a node of its own, so that a rule can name it; nothing is a catch-all.
// It knows the words that shape a block (IF, DEF, PROC, WHEN) and no others: which name is a G command, a procedure, an
// address, a cycle or a program of the shop, the tables of the dialect say.
// README.md beside this file is the vocabulary.
//
// Keywords are found among the names (`word`), never inside of one, and only where one can stand. They must stand before
// `name` in this file: of two tokens that match the same text the first one counts. No keyword holds a digit, so that
// blocks which differ in digits alone have the same tree.

/** A keyword in capitals or small letters. Letter by letter, because /…/i would also take U+017F for S. */
const anyCase = word => new RegExp([...word].map(letter =>
  /[A-Z]/.test(letter) ? `[${letter}${letter.toLowerCase()}]` : letter).join(''));

/** One token for a keyword, whatever its case, under one name. */
const keyword = word => alias(token(anyCase(word)), word);

/** One token for any of the words. */
const anyOf = words => token(choice(...words.map(anyCase)));

/** Words of one rule and commas between them. */
const listOf = rule => seq(rule, repeat(seq(',', rule)));

/** The same, of which any may be left out: `(1,,2)`. */
const listWithGaps = rule => seq(optional(rule), repeat(seq(',', optional(rule))));

// Blanks inside a word that is one token. The control reads & as a blank (NC programming 12/2019, p.52).
const blank = '[ \\t&]*';
const digits = '([0-9]+\\.?[0-9]*|\\.[0-9]+)([Ee][Xx][+-]?[0-9]+)?';
const letter = '[A-MO-Za-mo-z]'; // N numbers the block

// Precedence of operators, high binds tighter (NC programming 12/2019, p.444): comparisons bind looser than AND and OR.
const binds = {
  comparison: 1, concatenation: 2, or: 3, xor: 4, and: 5, bitOr: 6, bitXor: 7, bitAnd: 8, additive: 9, multiplicative: 10, not: 11,
  chain: 12, sign: 13,
};

const types = ['INT', 'REAL', 'BOOL', 'CHAR', 'AXIS', 'FRAME'];
const modifiers = ['NCK', 'CHAN', 'SYNR', 'SYNW', 'SYNRW', 'INIPO', 'INIRE', 'INICF', 'PRLOC', 'DCM', 'DCI', 'DCU'];
const numberedModifiers = ['LLI', 'ULI', 'PHU', 'APR', 'APW', 'APX', 'APRP', 'APWP', 'APRB', 'APWB'];

module.exports = grammar({
  name: 'sinumerik',

  word: $ => $.name,

  extras: $ => [/[ \t\x00\x1A\uFEFF&]/, $.comment],

  rules: {
    file: $ => seq(optional($._line), repeat(seq($._end_of_block, optional($._line)))),

    _end_of_block: $ => /\r\n?|\n\r*/,

    _line: $ => choice($.program_mark, $.block),

    comment: $ => /;[^\r\n]*/,

    // Heads each program of an archive: `%_N_SHAFT_MPF`.
    program_mark: $ => /%[^\r\n]*/,

    // Blocks. A block number behind words begins the next block, whose line end was lost.
    block: $ => choice(
      repeat1($._head),
      seq(repeat($._head), choice($._content, alias($._line_of_signs, $.remark)), repeat(choice($._content, $.block_number)))),

    _head: $ => choice($.skip, $.block_number, $.main_block_number, $.label),
    skip: $ => /\/[0-9]?/,
    block_number: $ => /[Nn][ \t&]*[0-9]+/,
    main_block_number: $ => /:[ \t&]*[0-9]+/,
    // The colon of a Chinese keyboard (U+FF1A) is no colon. Where a blank stands before it, the name is a child.
    label: $ => choice($._label, seq($.name, choice(':', '\uFF1A'))),
    _label: $ => /([A-MO-Za-mo-z_][A-Za-z0-9_\u00C0-\u024F]*|[Nn][A-Za-z_][A-Za-z0-9_\u00C0-\u024F]*)[:\uFF1A]/,

    _content: $ => choice($._any_word, $._statement, $.remark),

    // A comment that lacks its `;`. Only where nothing else begins so: what is not ASCII stands in strings and comments alone.
    remark: $ => /[^\x00-\x7F][^;\r\n]*/,
    // `------ bore ------`, `# bore`, `// bore`.
    _line_of_signs: $ => /([-*#][-*#=]+|#[ \t]*[A-Za-z]|\/\/)[^;\r\n]*/,

    // Words
    _any_word: $ => choice(
      $.literal_word, $.program_number, $.assignment, $.command, $.indexed_command, $.call, $.unassigned_word, $.empty_word,
      $.malformed_word, $.foreign_comment),

    // `L0100` calls a program; leading zeros count. It stands before the words, whose letters take in L.
    program_number: $ => /[Ll][0-9]+/,
    literal_word: $ => $._literal_word,
    _literal_word: $ => token(new RegExp(`${letter}${blank}[+-]?${blank}${digits}`)),
    // Two signs, two points, or a decimal comma.
    malformed_word: $ => token(choice(
      new RegExp(`${letter}${blank}[+-]?${blank}[0-9]*\\.[0-9]*\\.[0-9.]*`),
      new RegExp(`${letter}${blank}[+-]?${blank}[0-9]+,[0-9]+`),
      new RegExp(`${letter}${blank}[+-]${blank}[+-][+\\-]*${blank}${digits}`))),
    // `X=R1`, `X1=10`, `R5=2`, `SPOS[2]=90`, `CR=12.5`, `A[3]=SET(1,2)`. What `left` is, the tables say.
    assignment: $ => seq(
      field('left', $._target), field('operator', choice('=', alias('==', $.equality_sign))),
      field('right', choice($._expression, $.value_list))),
    _target: $ => choice(
      alias($._literal_word, $.numbered_address), alias($.program_number, $.numbered_address), alias($._letter, $.address),
      $.indexed_address, $.name, $.malformed_name, $.indexed_name, $.system_variable, $.foreign_variable),
    value_list: $ => seq($._open, optional($._expression), repeat1(seq(',', optional($._expression))), ')'),

    // A name alone: a G command (`SUPA`), a procedure (`STOPRE`), a macro, or the call of a program.
    command: $ => prec(-1, field('name', choice($.name, $.malformed_name))),
    indexed_command: $ => prec(-1, choice($.indexed_name, $.indexed_address)),
    call: $ => prec(1, seq(field('name', choice($.name, $.program_number)), field('arguments', $.argument_list))),

    // The = is missing before what is no plain number: `X (R1+5)`, `Y - DEPTH`, `T"DRILL"`.
    unassigned_word: $ => prec(1, seq(field('address', alias($._letter, $.address)), field('value', $._unassigned))),
    _unassigned: $ => choice(
      $.parenthesis, $.name, $.indexed_name, $.system_variable, $.function_call, $.string, alias($._signed_name, $.unary)),
    _signed_name: $ => prec(binds.sign, seq(
      field('operator', $._sign), field('operand', choice($.parenthesis, $.name, $.indexed_name, $.r_parameter, $.system_variable)))),

    empty_word: $ => prec(-1, alias($._letter, $.address)),
    _letter: $ => token(new RegExp(letter)),

    // A comment of other controls. Where arguments can stand, `(` opens these.
    foreign_comment: $ => /\([^()\r\n;=]*\)/,
    _open: $ => alias(token(prec(1, '(')), '('),

    // Statements
    _statement: $ => choice(
      $.definition, $.redefinition, $.macro_definition, $.program_definition, $.external_declaration,
      $.if_statement, $.else_statement, $.endif_statement, $.while_statement, $.endwhile_statement, $.for_statement,
      $.endfor_statement, $.loop_statement, $.endloop_statement, $.repeat_statement, $.until_statement,
      $.repetition, $.case_statement, $.goto_statement, $.restart_statement,
      $.synchronised_action, $.modal_call, $.indirect_call, $.path_call, $.iso_call,
      $.then_statement, $.elseif_statement),

    definition: $ => seq(
      keyword('DEF'), repeat($.modifier), field('type', $.type), repeat($.modifier), listOf($.declarator)),
    type: $ => choice(anyOf(types), prec.right(seq(keyword('STRING'), optional(seq('[', optional(field('length', $._expression)), ']'))))),
    modifier: $ => choice(anyOf(modifiers), seq(anyOf(numberedModifiers), choice($.number, alias($._signed_number, $.unary), $.name))),
    declarator: $ => seq(
      field('name', $._declared_name), optional(field('size', $.index_list)),
      optional(seq('=', field('value', choice($._expression, $.value_list))))),
    _declared_name: $ => choice($.name, $.malformed_name, $.axis_name, alias($._r_number, $.axis_name)),

    redefinition: $ => prec.right(seq(
      keyword('REDEF'), field('name', choice($.name, $.system_variable)),
      repeat1(choice($.modifier, $.number, $.name, alias($._signed_number, $.unary), $.string)))),

    // What stands behind AS may be any piece of a block; it is read where the name stands.
    macro_definition: $ => seq(keyword('DEFINE'), field('name', choice($.name, $.axis_name)), keyword('AS'), optional(field('body', $.macro_body))),
    // One word, too: else it would be one of the block.
    macro_body: $ => token(prec(1, /[^;\r\n \t][^;\r\n]*/)),

    program_definition: $ => prec.right(seq(
      keyword('PROC'), field('name', choice($.name, $.malformed_name, $.axis_name, $.program_number)), optional(field('parameters', $.parameter_list)),
      repeat(field('attribute', alias($.name, $.attribute))))),
    parameter_list: $ => seq($._open, optional(listOf($.parameter)), ')'),
    parameter: $ => seq(
      optional(field('reference', keyword('VAR'))), field('type', $.type), field('name', $._declared_name),
      optional(field('size', $.index_list)), optional(seq('=', field('value', $._expression)))),

    external_declaration: $ => seq(
      keyword('EXTERN'), field('name', choice($.name, $.program_number)),
      optional(field('parameters', alias($._external_list, $.parameter_list)))),
    _external_list: $ => seq($._open, optional(listOf(alias($._external_parameter, $.parameter))), ')'),
    _external_parameter: $ => seq(
      optional(field('reference', keyword('VAR'))), field('type', $.type), optional(field('name', choice($.name, $.axis_name))),
      optional(field('size', $.index_list)), optional(seq('=', field('value', $._expression)))),

    // With a jump behind it IF stands alone; any other is closed by ENDIF.
    if_statement: $ => prec.right(seq(
      keyword('IF'), field('condition', $._expression), optional(field('jump', choice($.goto_statement, $.restart_statement))))),
    else_statement: $ => keyword('ELSE'),
    endif_statement: $ => keyword('ENDIF'),
    while_statement: $ => seq(keyword('WHILE'), field('condition', $._expression)),
    endwhile_statement: $ => keyword('ENDWHILE'),
    for_statement: $ => seq(
      keyword('FOR'), field('counter', $._target), '=', field('first', $._expression), keyword('TO'), field('last', $._expression)),
    endfor_statement: $ => keyword('ENDFOR'),
    loop_statement: $ => keyword('LOOP'),
    endloop_statement: $ => keyword('ENDLOOP'),
    repeat_statement: $ => prec(-1, keyword('REPEAT')),
    until_statement: $ => seq(keyword('UNTIL'), field('condition', $._expression)),

    // Of other languages.
    then_statement: $ => keyword('THEN'),
    elseif_statement: $ => seq(field('keyword', alias(anyOf(['ELSEIF', 'ELSIF', 'ELIF']), $.foreign_keyword)), field('condition', $._expression)),

    // REPEAT with a label repeats a part of the program. How often (`P3`, `P=COUNT`) is a word of its own behind it.
    repetition: $ => prec.right(choice(
      seq(keyword('REPEAT'), field('first', $._mark), optional(field('last', $._mark))),
      seq(keyword('REPEATB'), field('first', $._mark)))),
    _mark: $ => choice($.name, $.block_number),

    case_statement: $ => prec.right(seq(
      keyword('CASE'), field('value', $._expression), keyword('OF'), repeat1($.case_arm), optional($.default_arm))),
    case_arm: $ => seq(optional(field('again', keyword('OF'))), field('value', $._case_value), alias($._case_jump, $.goto_statement)),
    _case_value: $ => choice($.number, $.based_number, $.string, $.name, $.indexed_name, alias($._signed_number, $.unary)),
    default_arm: $ => seq(keyword('DEFAULT'), $.goto_statement),
    // Its target subtracts nothing: in `1 GOTOF ROW -1 GOTOF COLUMN` the -1 is the next value.
    _case_jump: $ => prec.right(seq(field('direction', $._direction), field('target', choice($._case_target, $.number, $._written_target)))),
    _case_target: $ => choice($.name, $.axis_name, $.string, $.parenthesis, $.r_parameter, alias($._joined_target, $.concatenation)),
    _joined_target: $ => prec.left(binds.concatenation, seq(
      field('left', $._case_target), field('operator', alias('<<', $.operator)), field('right', $._case_target))),

    // A label as target has no colon behind it.
    goto_statement: $ => prec.right(seq(
      field('direction', $._direction), field('target', choice($._expression, $._written_target)))),
    _direction: $ => alias(anyOf(['GOTO', 'GOTOF', 'GOTOB', 'GOTOC']), $.direction),
    _written_target: $ => choice($.block_number, $.main_block_number, alias($._label, $.label)),
    restart_statement: $ => keyword('GOTOS'),

    // Its ID=1 is an assignment in front of it.
    synchronised_action: $ => prec.right(seq(
      optional(seq(
        field('frequency', alias(anyOf(['WHEN', 'WHENEVER', 'EVERY', 'FROM']), $.frequency)),
        optional(field('units', alias($._units, $.literal_word))), field('condition', $._expression))),
      keyword('DO'), repeat(field('action', $._any_word)),
      optional(seq(keyword('ELSE'), repeat(field('alternative', $._any_word)))))),

    // `G71`; an R parameter there begins the condition.
    _units: $ => /[Gg][ \t&]*[0-9]+/,

    modal_call: $ => prec.right(seq(keyword('MCALL'), optional(field('program', choice($.name, $.call, $.program_number))))),
    indirect_call: $ => prec.right(seq(
      keyword('CALL'), optional(field('program', choice($._expression, $.program_number))),
      optional(seq(
        keyword('BLOCK'), field('first', choice($._expression, $.block_number)),
        keyword('TO'), field('last', choice($._expression, $.block_number)))))),
    path_call: $ => prec.right(seq(
      keyword('PCALL'), choice(seq(field('program', $.path), optional(field('arguments', $.argument_list))), field('program', $._expression)))),
    path: $ => /([A-Za-z0-9_]+:)?(\/+[A-Za-z0-9_]+:?)+/,
    iso_call: $ => seq(keyword('ISOCALL'), field('program', $._expression)),

    // Expressions
    _expression: $ => choice(
      $.number, $.based_number, $.string, $.unclosed_string, $.typographic_string,
      $.name, $.malformed_name, $.r_parameter, $.axis_name, $.indexed_name, alias($._indexed_axis, $.indexed_address), $.system_variable, $.foreign_variable,
      $.parenthesis, $.square_parenthesis, $.function_call, $.unary, $.binary, $.logical, $.comparison, $.concatenation, $.frame_chain),

    number: $ => token(new RegExp(digits)),
    based_number: $ => /'[HhBbDd][0-9A-Fa-f]*'/,
    // A quotation mark inside is written '"'.
    string: $ => /"([^"'\r\n]|'"'|')*"/,
    unclosed_string: $ => /"[^"\r\n]*/,
    typographic_string: $ => /[\u201C-\u201F\u00AB\u00BB][^"\u201C-\u201F\u00AB\u00BB\r\n]*[\u201C-\u201F\u00AB\u00BB]/,

    // The second operand is a macro of Siemens' cycles: `(NUMBER _DEC1)`.
    parenthesis: $ => seq($._open, $._expression, optional(field('macro', alias($.name, $.macro_operand))), ')'),
    // Of other controls: `X=-[DEPTH]`.
    square_parenthesis: $ => seq('[', $._expression, ']'),

    function_call: $ => seq(field('function', alias($.name, $.function)), field('arguments', $.argument_list)),
    argument_list: $ => seq($._open, listWithGaps($._expression), ')'),

    unary: $ => choice(
      prec(binds.sign, seq(field('operator', $._sign), field('operand', $._expression))),
      prec(binds.not, seq(field('operator', alias(anyOf(['NOT', 'B_NOT']), $.operator)), field('operand', $._expression))),
      prec.left(binds.concatenation, seq(field('operator', alias('<<', $.operator)), field('operand', $._expression)))),
    _signed_number: $ => seq(field('operator', $._sign), field('operand', $.number)),
    _sign: $ => choice(alias('-', $.operator), alias('+', $.operator)),

    binary: $ => choice(
      prec.left(binds.multiplicative, seq(
        field('left', $._expression),
        field('operator', choice(alias('*', $.operator), alias('/', $.operator), alias(anyOf(['DIV', 'MOD']), $.operator))),
        field('right', $._expression))),
      prec.left(binds.additive, seq(field('left', $._expression), field('operator', $._sign), field('right', $._expression))),
      ...[[binds.bitAnd, 'B_AND'], [binds.bitXor, 'B_XOR'], [binds.bitOr, 'B_OR']].map(([strength, word]) => prec.left(strength, seq(
        field('left', $._expression), field('operator', alias(token(anyCase(word)), $.operator)), field('right', $._expression))))),

    logical: $ => choice(...[[binds.and, 'AND'], [binds.xor, 'XOR'], [binds.or, 'OR']].map(([strength, word]) => prec.left(strength, seq(
      field('left', $._expression), field('operator', alias(token(anyCase(word)), $.operator)), field('right', $._expression))))),

    comparison: $ => prec.left(binds.comparison, seq(
      field('left', $._expression),
      field('operator', choice(
        alias($._comparison, $.operator), alias('==', $.operator), alias('=', $.assignment_sign),
        alias($._foreign_sign, $.foreign_operator), alias(anyOf(['EQ', 'NE', 'GT', 'GE', 'LT', 'LE']), $.foreign_operator))),
      field('right', $._expression))),
    _comparison: $ => token(choice('<>', '<', '<=', '>', '>=')),
    _foreign_sign: $ => token(choice('!=', '=<', '=>', '><')),

    concatenation: $ => prec.left(binds.concatenation, seq(
      field('left', $._expression), field('operator', alias('<<', $.operator)), field('right', $._expression))),
    frame_chain: $ => prec.left(binds.chain, seq(field('left', $._expression), field('operator', alias(':', $.operator)), field('right', $._expression))),

    // Variables
    indexed_name: $ => seq(field('name', $.name), field('index', $.index_list)),
    indexed_address: $ => seq(
      field('address', choice(alias($._letter, $.address), alias($._literal_word, $.numbered_address))), field('index', $.index_list)),
    _indexed_axis: $ => seq(field('address', choice($.axis_name, alias($._r_number, $.axis_name))), field('index', $.index_list)),
    system_variable: $ => prec.right(seq(field('name', $.system_name), optional(field('index', $.index_list)))),
    system_name: $ => /\$\$?[A-Za-z_][A-Za-z0-9_]*/,
    index_list: $ => seq('[', listWithGaps($._expression), ']'),

    // Blanks may stand before the number.
    r_parameter: $ => $._r_number,
    _r_number: $ => token(/[Rr][ \t&]*[0-9]+/),
    foreign_variable: $ => /#[ \t]*[0-9]+/,

    // Two letters or _ come first, so that no word of a letter and a number is a name.
    name: $ => /[A-Za-z_][A-Za-z_][A-Za-z0-9_]*/,
    // `D1_FAST`, `LÄNGE`
    malformed_name: $ => token(choice(
      /[A-MO-Za-mo-z][0-9]+_[A-Za-z0-9_]*/, /[A-Za-z_][A-Za-z0-9_]*[\u00C0-\u024F][A-Za-z0-9_\u00C0-\u024F]*/)),
    // An axis, or a parameter of one letter.
    axis_name: $ => token(/[A-Za-z][0-9]*/),
  },
});
