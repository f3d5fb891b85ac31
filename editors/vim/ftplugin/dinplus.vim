" DIN PLUS: comments, sections as folds, and maclint behind :make.

if exists('b:did_ftplugin')
  finish
endif
let b:did_ftplugin = 1

setlocal commentstring=[%s]
setlocal comments=
compiler maclint
let b:undo_ftplugin = 'setlocal commentstring< comments< foldexpr< foldmethod< makeprg< errorformat<'

" A section goes up to the next: a line that begins with a capital word of three letters or more, without a block number.
function! MaclintFoldOfSections(number) abort
  let l:text = getline(a:number)
  let l:is_keyword = l:text =~# '^\s*\%(IF\|THEN\|ELSE\|ENDIF\|WHILE\|ENDWHILE\|SWITCH\|CASE\|DEFAULT\|BREAK\|ENDSWITCH\|RETURN\|PRINT\|INPUT\|WINDOW\|UNIT\|END_OF_UNIT\|BLOCKSTART\|BLOCKEND\)\>'
  return l:text =~# '^\s*\u\{3,}' && !l:is_keyword ? '>1' : '='
endfunction
setlocal foldmethod=expr
setlocal foldexpr=MaclintFoldOfSections(v:lnum)
setlocal foldlevel=99

if has('nvim-0.9')
  " Colours, where parser/dinplus.so and queries/dinplus lie on the runtime path.
  lua pcall(vim.treesitter.start)
endif
