//! Starts `maclint lsp` for the languages of extension.toml.
use zed_extension_api::{self as zed, Command, LanguageServerId, Result, Worktree};

struct Maclint;

impl zed::Extension for Maclint {
    fn new() -> Self {
        Maclint
    }

    /// The maclint on the user's PATH; a folder's settings have no say.
    fn language_server_command(&mut self, _: &LanguageServerId, worktree: &Worktree) -> Result<Command> {
        let command = worktree.which("maclint").ok_or("maclint is not on the PATH: install it first")?;
        Ok(Command { command, args: vec!["lsp".to_string()], env: vec![] })
    }
}

zed::register_extension!(Maclint);
