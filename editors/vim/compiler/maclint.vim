" :compiler maclint, then :make % for a program with those around it, or :make for the whole folder.

if exists('current_compiler')
  finish
endif
let current_compiler = 'maclint'

if exists(':CompilerSet') != 2
  command -nargs=* CompilerSet setlocal <args>
endif

" Where the output is a terminal to maclint, it would be coloured, and end after 100 findings.
CompilerSet makeprg=maclint\ --format\ concise\ --quiet\ --color\ never\ --max-findings\ all
" %v, not %c: maclint counts letters, Vim's columns are bytes.
" O9100.nc:3:12: error[MAC303] Jump into a loop: ... Other lines, such as those on a wrong configuration, stay as they are.
CompilerSet errorformat=%f:%l:%v:\ %trror%m,%f:%l:%v:\ %tarning%m,%f:%l:%v:\ %tote%m
