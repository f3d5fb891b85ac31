" File types of NC programs: fanuc and dinplus, named like the tree-sitter grammars.
" A name tells little: .nc is used for both languages, so the first lines decide.

function! s:SetType() abort
  for l:line in getline(1, 100)
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

augroup maclint_filetypes
  autocmd!
  " .tap would be a test report, and some of the others belong to other languages as well: `set`, not `setfiletype`.
  autocmd BufNewFile,BufRead *.[nN][cC],*.[tT][aA][pP],*.[cC][nN][cC],*.[mM][iI][nN],*.[nN][cC][sS],*.[nN][cC][dD],*.[eE][iI][aA] call s:SetType()
  " O1234 and O1234_TORUS, as controls name their files.
  autocmd BufNewFile,BufRead [oO][0-9]* if expand('%:t') =~? '^O\d\+\%($\|[_ (-]\)' && expand('%:e') ==# '' | call s:SetType() | endif
augroup END
