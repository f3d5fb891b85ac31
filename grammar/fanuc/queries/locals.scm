; Variables of a program. Sequence numbers are no names: N20 is written 20 in GOTO20.
(file) @local.scope
(assignment left: [(variable) (foreign_variable) (named_variable)] @local.definition)
[(variable) (foreign_variable) (named_variable)] @local.reference
