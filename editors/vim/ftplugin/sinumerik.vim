" SINUMERIK: comments, structures as folds, and maclint behind :make.

if exists('b:did_ftplugin')
  finish
endif
let b:did_ftplugin = 1

setlocal commentstring=;%s
setlocal comments=:;
compiler maclint
let b:undo_ftplugin = 'setlocal commentstring< comments< foldexpr< foldmethod< makeprg< errorformat<'

" One level for each structure up to its end. IF with a jump behind it stands alone, and so does REPEAT with a label.
function! MaclintFoldOfStructures(number) abort
  let l:text = substitute(getline(a:number), '\c^\s*\%(N\s*\d\+\s*\)\?\|;.*', '', 'g')
  if l:text =~? '^\%(IF\>\%(.*\<GOTO\)\@!\|FOR\>\|LOOP\>\|WHILE\>\|REPEAT\s*$\)'
    return 'a1'
  endif
  return l:text =~? '^\%(ENDIF\|ENDFOR\|ENDLOOP\|ENDWHILE\|UNTIL\)\>' ? 's1' : '='
endfunction
setlocal foldmethod=expr
setlocal foldexpr=MaclintFoldOfStructures(v:lnum)
setlocal foldlevel=99

if has('nvim-0.9')
  " Colours, where parser/sinumerik.so and queries/sinumerik lie on the runtime path.
  lua pcall(vim.treesitter.start)
endif
