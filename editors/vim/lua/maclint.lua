-- The language server in Neovim from 0.7 on: require('maclint').setup()
local M = {}

local filetypes = { 'fanuc', 'dinplus', 'sinumerik' }
local get_clients = vim.lsp.get_clients or vim.lsp.get_active_clients

local function client()
  for _, each in ipairs(get_clients()) do
    if each.name == 'maclint' and vim.lsp.buf_is_attached(0, each.id) then
      return each
    end
  end
  error('maclint: no server reads this buffer', 0)
end

-- Waits for the answer; what the server refuses is an error in its own words.
local function ask(method, params)
  local answers, failure = vim.lsp.buf_request_sync(0, method, params, 10000)
  local answer = answers and answers[client().id]
  if not answer then
    error('maclint: the server does not answer: ' .. (failure or 'the request is not for it'), 0)
  end
  local refusal = answer.error or answer.err
  if refusal then
    error('maclint: ' .. refusal.message, 0)
  end
  return answer.result
end

local function apply(edit)
  vim.lsp.util.apply_workspace_edit(edit, client().offset_encoding)
end

-- Shows the page of a rule, such as MAC303, in a window of its own.
function M.explain(code)
  local page = ask('workspace/executeCommand', { command = 'maclint.explain', arguments = { code } })
  vim.cmd('new')
  vim.bo.buftype, vim.bo.bufhidden, vim.bo.swapfile, vim.bo.filetype = 'nofile', 'wipe', false, 'markdown'
  vim.api.nvim_buf_set_lines(0, 0, -1, false, vim.split(page.markdown, '\n'))
end

-- All fixes of this program that are safe.
function M.fix_all()
  local params = {
    textDocument = vim.lsp.util.make_text_document_params(),
    range = { start = { line = 0, character = 0 }, ['end'] = { line = vim.api.nvim_buf_line_count(0), character = 0 } },
    context = { diagnostics = {}, only = { 'source.fixAll.maclint' } },
  }
  local actions = ask('textDocument/codeAction', params)
  if actions and actions[1] then
    apply(actions[1].edit)
  end
end

function M.renumber()
  local edit = ask('workspace/executeCommand', { command = 'maclint.renumber', arguments = { vim.uri_from_bufnr(0) } })
  if edit then
    apply(edit)
  end
end

-- Before 0.11: one server a root folder.
local servers = {}

local function root_of(folder)
  for _, found in ipairs({ vim.fn.findfile('.maclint.json', folder .. ';'), vim.fn.finddir('.git', folder .. ';') }) do
    if found ~= '' then
      return vim.fn.fnamemodify(found, ':p:s?/$??:h')
    end
  end
  return folder
end

local function attach(command)
  local name = vim.api.nvim_buf_get_name(0)
  if name == '' or vim.bo.buftype ~= '' then
    return
  end
  local root = root_of(vim.fn.fnamemodify(name, ':p:h'))
  servers[root] = servers[root] or vim.lsp.start_client({
    name = 'maclint',
    cmd = command,
    root_dir = root,
    workspace_folders = { { uri = vim.uri_from_fname(root), name = root } },
    on_exit = function() servers[root] = nil end,
  })
  if servers[root] then
    vim.lsp.buf_attach_client(0, servers[root])
  end
end

local function attach_old(command)
  local group = vim.api.nvim_create_augroup('maclint_lsp', {})
  vim.api.nvim_create_autocmd('FileType', { group = group, pattern = filetypes, callback = function() attach(command) end })
end

-- options.cmd: the words that start the server, where that is not { 'maclint', 'lsp' }.
function M.setup(options)
  local command = options and options.cmd or { 'maclint', 'lsp' }
  vim.lsp.commands['maclint.explain'] = function(asked) M.explain(asked.arguments[1]) end
  vim.api.nvim_create_user_command('MaclintExplain', function(given) M.explain(given.args) end, { nargs = 1 })
  vim.api.nvim_create_user_command('MaclintFixAll', M.fix_all, {})
  vim.api.nvim_create_user_command('MaclintRenumber', M.renumber, {})
  if vim.lsp.enable then
    vim.lsp.config('maclint', { cmd = command })
    vim.lsp.enable('maclint')
  else
    attach_old(command)
  end
end

return M
