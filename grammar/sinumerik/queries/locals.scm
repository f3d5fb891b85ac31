; Variables of a program. R parameters are written alike where they are set and where they are used.
(file) @local.scope
(declarator name: (name) @local.definition)
(parameter name: [(name) (axis_name)] @local.definition)
(macro_definition name: (name) @local.definition)
(assignment left: (numbered_address) @local.definition (#match? @local.definition "^[Rr]"))
[(name) (r_parameter) (axis_name)] @local.reference
