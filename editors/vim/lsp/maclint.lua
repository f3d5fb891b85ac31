-- For Neovim 0.11 and later: vim.lsp.enable('maclint') starts `maclint lsp` for NC programs.
return {
  cmd = { 'maclint', 'lsp' },
  filetypes = { 'fanuc', 'dinplus', 'sinumerik' },
  root_markers = { '.maclint.json', '.git' },
}
