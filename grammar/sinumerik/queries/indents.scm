; Heads of programs begin the line. Structures are blocks one after the other, which no query can pair: the line above leads.
(program_mark) @indent.zero
(block (program_definition)) @indent.zero
(block) @indent.auto
