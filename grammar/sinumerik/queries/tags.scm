; Programs and labels, and where they are called. A name alone may be a call as well as a G command, which no query can tell.
(program_definition name: [(name) (program_number)] @name) @definition.function
(macro_definition name: (name) @name) @definition.macro
(label) @name @definition.label
(call name: [(name) (program_number)] @name) @reference.call
(modal_call program: [(name) (program_number)] @name) @reference.call
(block (program_number) @name) @reference.call
