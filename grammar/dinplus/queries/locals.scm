; Variables and constants, which are written alike where they are set and where they are used.
(file) @local.scope
(assignment left: [(variable) (named_variable) (transfer_variable) (constant)] @local.definition)
(declaration name: [(named_variable) (constant)] @local.definition)
[(variable) (named_variable) (transfer_variable) (constant)] @local.reference
