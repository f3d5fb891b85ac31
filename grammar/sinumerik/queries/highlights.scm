; Colours for editors.
(comment) @comment
[(remark) (foreign_comment) (malformed_word) (malformed_name) (unassigned_word) (empty_word) (equality_sign) (assignment_sign) (foreign_operator)
 (foreign_variable) (foreign_keyword) (then_statement) (unclosed_string) (typographic_string) (square_parenthesis)] @error

(program_mark) @module
(skip) @punctuation.special
[(block_number) (main_block_number) (label)] @label

[(literal_word) (numbered_address) (address)] @property
(assignment left: (name) @property)
(assignment left: (indexed_name name: (name) @property))
(command name: (name) @keyword.directive)
(call name: [(name) (program_number)] @function.call)
(program_number) @function.call
(function) @function.builtin
(macro_operand) @constant.macro
(program_definition name: [(name) (program_number)] @function)
(external_declaration name: [(name) (program_number)] @function)
(parameter name: [(name) (axis_name)] @variable.parameter)
(declarator name: [(name) (axis_name)] @variable)
(macro_definition name: [(name) (axis_name)] @constant.macro)
(macro_body) @string.special
(path) @string.special.path
(goto_statement target: (name) @label)
(repetition first: (name) @label)
(repetition last: (name) @label)

[(number) (based_number)] @number
(string) @string

["IF" "ELSE" "ENDIF" "CASE" "OF" "DEFAULT" "GOTOS" (direction)] @keyword.conditional
["FOR" "TO" "ENDFOR" "LOOP" "ENDLOOP" "WHILE" "ENDWHILE" "REPEAT" "REPEATB" "UNTIL"] @keyword.repeat
["PROC" "EXTERN" "MCALL" "CALL" "PCALL" "ISOCALL" "BLOCK" (attribute)] @keyword.function
["DEF" "REDEF" "DEFINE" "AS" "VAR" (modifier)] @keyword.modifier
["DO" (frequency)] @keyword
(type) @type

[(operator) "="] @operator
["(" ")" "[" "]"] @punctuation.bracket
"," @punctuation.delimiter

[(r_parameter) (name)] @variable
(axis_name) @property
(system_name) @variable.builtin
