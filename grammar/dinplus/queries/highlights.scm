; Colours for editors.
[(comment) (description_mark)] @comment
[(unclosed_comment) (unclosed_string) (typographic_string) (foreign_comment) (stray_parenthesis) (stray_bracket) (malformed_word)
 (letter_o_word) (lower_case_word) (foreign_variable) (equality_sign) (assignment_sign) (foreign_operator) (unknown_keyword)
 (unknown_function)] @error

["%" (program_name)] @module
(section_name) @keyword.directive
(header_name) @attribute
(header_value) @string
[(slide) (skip)] @punctuation.special
[(block_number) (computed_block_number)] @label

[(literal_word) (address) (axis) (incremental)] @property
(unknown_coordinate) @constant.builtin
(number) @number
(string) @string

["IF" "SWITCH" "THEN" "ELSE" "ENDIF" "CASE" "DEFAULT" "BREAK" "ENDSWITCH"] @keyword.conditional
["WHILE" "ENDWHILE"] @keyword.repeat
"RETURN" @keyword.return
["PRINT" "INPUT" "WINDOW" "UNIT" "END_OF_UNIT" "BLOCKSTART" "BLOCKEND"] @keyword
"L" @function.call

(function) @function.builtin
[(operator) "="] @operator
["(" ")"] @punctuation.bracket
"," @punctuation.delimiter

[(variable) (selected_variable) (indirect_variable) (named_variable) (double_sharp)] @variable
(transfer_variable) @variable.parameter
(constant) @constant
(internal_constant) @constant.builtin
(selector) @property
