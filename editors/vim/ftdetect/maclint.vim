" File types of NC programs: fanuc, dinplus and sinumerik, named like the tree-sitter grammars.
" A name tells little: .nc is used for all of them, so the first lines decide.

function! s:SetType() abort
  for l:line in getline(1, 100)
    " Heads of programs that a SINUMERIK control has written.
    if l:line =~# '^\s*\%(%_N_\|;\$PATH=\)'
      setlocal filetype=sinumerik
      return
    endif
    " Only DIN PLUS has header entries (#UNIT METRIC), sections (capital words without a number before them, in any
    " language) and comments in brackets.
    if l:line =~# '^\s*#\u\{2,}' || l:line =~# '^\s*\[[/ ]*\a' ||
          \ l:line =~# '^\s*\%(GOTO\|WHILE\|POPEN\|PCLOS\|[DB]PRNT\|SETVN\)\@!\u\{4,}\%([ _"[]\|$\)'
      setlocal filetype=dinplus
      return
    endif
  endfor
  execute 'setlocal filetype=' . (expand('%:e') ==? 'ncs' ? 'dinplus' : 'fanuc')
endfunction

" .def belongs to linkers of Windows as well.
function! s:SetTypeOfDefinitions() abort
  if join(getline(1, 20), "\n") !~? '\%(^\|\n\)\s*\%(LIBRARY\|EXPORTS\|DESCRIPTION\)\>'
    setlocal filetype=sinumerik
  endif
endfunction

augroup maclint_filetypes
  autocmd!
  " .tap would be a test report, and some of the others belong to other languages as well: `set`, not `setfiletype`.
  autocmd BufNewFile,BufRead *.[nN][cC],*.[tT][aA][pP],*.[cC][nN][cC],*.[mM][iI][nN],*.[nN][cC][sS],*.[nN][cC][dD],*.[eE][iI][aA] call s:SetType()
  autocmd BufNewFile,BufRead *.[mM][pP][fF],*.[sS][pP][fF],*.[aA][rR][cC],*.[cC][pP][fF] setlocal filetype=sinumerik
  autocmd BufNewFile,BufRead *.[dD][eE][fF] call s:SetTypeOfDefinitions()
  " O1234 and O1234_TORUS, as controls name their files.
  autocmd BufNewFile,BufRead [oO][0-9]* if expand('%:t') =~? '^O\d\+\%($\|[_ (-]\)' && expand('%:e') ==# '' | call s:SetType() | endif
augroup END
