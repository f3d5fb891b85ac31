; Programs, and where they are called: O9200 is P9200 there. Every block may have a number, so those are left out.
(program_number) @name @definition.function
(named_program name: (program_name) @name) @definition.function

; G65, G66, G66.1 or M98 stands somewhere in the block.
((block [(literal_word) (program_name)] @name) @reference.call
  (#match? @reference.call "(^|[^A-Za-z])[GgMm] *0*(65|66|66\\.1|98)([^0-9.]|$)")
  (#match? @name "^[Pp<]"))
((if_statement consequence: [(literal_word) (program_name)] @name) @reference.call
  (#match? @reference.call "[GgMm] *0*(65|66|66\\.1|98)([^0-9.]|$)")
  (#match? @name "^[Pp<]"))
