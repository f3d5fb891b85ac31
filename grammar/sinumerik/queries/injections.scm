; Remarks, for editors that mark TODO and addresses in them; what stands for a macro's name is a piece of a block.
((comment) @injection.content (#set! injection.language "comment"))
((macro_body) @injection.content (#set! injection.language "sinumerik"))
