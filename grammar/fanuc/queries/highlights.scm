; Colours for editors.
(comment) @comment
[(stray_parenthesis) (malformed_word) (letter_o_word)] @error

(tape_mark) @punctuation.special
(skip) @punctuation.special
[(program_number) (computed_program_number) (program_name)] @module
[(sequence_number) (computed_sequence_number) (label)] @label

[(literal_word) (address) (incremental)] @property
(bare_value) @number
(number) @number

["IF" "THEN" "GOTO"] @keyword.conditional
["WHILE" "DO" "END"] @keyword.repeat
["POPEN" "PCLOS" "DPRNT" "BPRNT" "SETVN"] @keyword
(foreign_keyword) @keyword

(function) @function.builtin
[(operator) (symbolic_operator) "="] @operator
["[" "]"] @punctuation.bracket
"," @punctuation.delimiter

[(variable) (indirect_variable) (double_sharp) (foreign_variable)] @variable
[(system_name) (user_name) (variable_name)] @variable.builtin
(output_text) @string
