; Sections begin the line, and comments over several lines keep theirs. IF and WHILE are blocks one after the other, which no query can pair.
[(program_name_line) (section)] @indent.zero
(comment) @indent.auto
(block) @indent.auto
