; The program, its sections, its subprograms with their names, and the calls of these.
(program_name_line name: (program_name) @name) @definition.module
(section name: (section_name) @name) @definition.section
(section parameter: (string) @name) @definition.function
(call name: (string) @name) @reference.call
