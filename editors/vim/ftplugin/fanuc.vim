" Fanuc macro code: comments, loops as folds, and maclint behind :make.

if exists('b:did_ftplugin')
  finish
endif
let b:did_ftplugin = 1

setlocal commentstring=(%s)
setlocal comments=
compiler maclint
let b:undo_ftplugin = 'setlocal commentstring< comments< foldexpr< foldmethod< makeprg< errorformat<'

" One level for each DO up to its END. Parse trees hold blocks one after the other, so a query cannot tell them.
function! MaclintFoldOfLoops(number) abort
  let l:text = substitute(getline(a:number), '([^)]*)\?', '', 'g')
  let l:begins = l:text =~? 'DO\s*[0-9#\[]'
  let l:ends = l:text =~? '\<\%(N\s*\d\+\s*\)\?END\s*[0-9#\[]'
  return l:begins && !l:ends ? 'a1' : l:ends && !l:begins ? 's1' : '='
endfunction
setlocal foldmethod=expr
setlocal foldexpr=MaclintFoldOfLoops(v:lnum)
setlocal foldlevel=99

if has('nvim-0.9')
  " Colours, where parser/fanuc.so and queries/fanuc lie on the runtime path.
  lua pcall(vim.treesitter.start)
endif
