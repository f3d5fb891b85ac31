; Heads of programs begin the line. Loops are blocks one after the other, which no query can pair: inside of them the line above leads.
(block [(program_number) (named_program)]) @indent.zero
(tape_mark) @indent.zero
(block) @indent.auto
