; Remarks, for editors that mark TODO and addresses in them.
((comment) @injection.content (#set! injection.language "comment"))
