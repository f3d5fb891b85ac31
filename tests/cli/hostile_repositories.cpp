//! The lists, by git's documentation as of 2.39 and what later versions added.
#include "tests/cli/hostile_repositories.hpp"

#include <array>

namespace maclint::test {
namespace {

// clang-format off
constexpr auto settings = std::to_array<HostileSetting>({
    {"core.fsmonitor",                "$ran",               "git-config core.fsmonitor"},
    {"core.fsmonitorHookVersion",     "1",                  "git-config core.fsmonitorHookVersion"},
    {"core.hooksPath",                "$ran.hooks",         "git-config core.hooksPath, githooks"},
    {"core.alternateRefsCommand",     "$ran",               "git-config core.alternateRefsCommand"},
    {"core.askPass",                  "$ran",               "git-config core.askPass"},
    {"core.editor",                   "$ran",               "git-config core.editor"},
    {"core.gitProxy",                 "$ran",               "git-config core.gitProxy"},
    {"core.pager",                    "$ran",               "git-config core.pager"},
    {"core.sshCommand",               "$ran",               "git-config core.sshCommand"},
    {"core.attributesFile",           "$all.attributes",    "git-config core.attributesFile"},
    {"alias.rev-parse",               "!$ran",              "git-config alias.*"},
    {"alias.ls-tree",                 "!$ran",              "git-config alias.*"},
    {"alias.cat-file",                "!$ran",              "git-config alias.*"},
    {"alias.x",                       "!$ran",              "git-config alias.*"},
    {"browser.x.cmd",                 "$ran",               "git-config browser.<tool>.cmd"},
    {"browser.x.path",                "$ran",               "git-config browser.<tool>.path"},
    {"web.browser",                   "$ran",               "git-web--browse web.browser"},
    {"credential.helper",             "!$ran",              "git-config credential.helper, gitcredentials"},
    {"diff.external",                 "$ran",               "git-config diff.external"},
    {"diff.x.command",                "$ran",               "git-config diff.<driver>.command"},
    {"diff.x.textconv",               "$ran",               "git-config diff.<driver>.textconv"},
    {"diff.tool",                     "x",                  "git-config diff.tool"},
    {"difftool.x.cmd",                "$ran",               "git-config difftool.<tool>.cmd"},
    {"difftool.x.path",               "$ran",               "git-config difftool.<tool>.path"},
    {"filter.x.clean",                "$ran",               "git-config filter.<driver>.clean, gitattributes"},
    {"filter.x.smudge",               "$ran",               "git-config filter.<driver>.smudge, gitattributes"},
    {"filter.x.process",              "$ran",               "gitattributes filter.<driver>.process"},
    {"filter.x.required",             "true",               "gitattributes filter.<driver>.required"},
    {"gc.recentObjectsHook",          "$ran",               "git-config gc.recentObjectsHook"},
    {"gpg.program",                   "$ran",               "git-config gpg.program"},
    {"gpg.openpgp.program",           "$ran",               "git-config gpg.<format>.program"},
    {"gpg.ssh.program",               "$ran",               "git-config gpg.<format>.program"},
    {"gpg.x509.program",              "$ran",               "git-config gpg.<format>.program"},
    {"gpg.ssh.defaultKeyCommand",     "$ran",               "git-config gpg.ssh.defaultKeyCommand"},
    {"log.showSignature",             "true",               "git-config log.showSignature"},
    {"guitool.x.cmd",                 "$ran",               "git-config guitool.<name>.cmd"},
    {"help.browser",                  "x",                  "git-config help.browser"},
    {"instaweb.browser",              "$ran",               "git-config instaweb.browser"},
    {"instaweb.httpd",                "$ran",               "git-config instaweb.httpd"},
    {"imap.tunnel",                   "$ran",               "git-config imap.tunnel"},
    {"interactive.diffFilter",        "$ran",               "git-config interactive.diffFilter"},
    {"man.x.cmd",                     "$ran",               "git-config man.<tool>.cmd"},
    {"man.x.path",                    "$ran",               "git-config man.<tool>.path"},
    {"merge.x.driver",                "$ran",               "git-config merge.<driver>.driver"},
    {"mergetool.x.cmd",               "$ran",               "git-config mergetool.<tool>.cmd"},
    {"mergetool.x.path",              "$ran",               "git-config mergetool.<tool>.path"},
    {"pager.rev-parse",               "$ran",               "git-config pager.<cmd>"},
    {"pager.ls-tree",                 "$ran",               "git-config pager.<cmd>"},
    {"pager.cat-file",                "$ran",               "git-config pager.<cmd>"},
    {"pager.diff",                    "$ran",               "git-config pager.<cmd>"},
    {"receive.procReceiveRefs",       "refs/heads",         "git-config receive.procReceiveRefs"},
    {"remote.x.receivepack",          "$ran",               "git-config remote.<name>.receivepack"},
    {"remote.x.uploadpack",           "$ran",               "git-config remote.<name>.uploadpack"},
    {"sendemail.smtpServer",          "$ran",               "git-config sendemail.*, git-send-email"},
    {"sendemail.sendmailCmd",         "$ran",               "git-config sendemail.*, git-send-email"},
    {"sendemail.toCmd",               "$ran",               "git-config sendemail.*, git-send-email"},
    {"sendemail.ccCmd",               "$ran",               "git-config sendemail.*, git-send-email"},
    {"sequence.editor",               "$ran",               "git-config sequence.editor"},
    {"submodule.x.update",            "!$ran",              "git-config submodule.<name>.update"},
    {"tar.x.command",                 "$ran",               "git-archive tar.<format>.command"},
    {"trailer.x.cmd",                 "$ran",               "git-interpret-trailers trailer.<token>.cmd"},
    {"trailer.x.command",             "$ran",               "git-interpret-trailers trailer.<token>.command"},
    {"trace2.normalTarget",           "$mark",              "git-config trace2.*: a file that is written"},
    {"trace2.eventTarget",            "$mark",              "git-config trace2.*"},
    {"trace2.perfTarget",             "$mark",              "git-config trace2.*"},
    {"uploadpack.packObjectsHook",    "$ran",               "git-config uploadpack.packObjectsHook"},
    {"hook.x.command",                "$ran",               "git-config hook.<name>.command, later versions"},
    {"hook.x.event",                  "post-index-change",  "git-config hook.<name>.event, later versions"},
    {"promisor.acceptFromServer",     "all",                "git-config promisor.acceptFromServer"},
    {"protocol.allow",                "always",             "git-config protocol.allow"},
    {"protocol.ext.allow",            "always",             "git-config protocol.<name>.allow"},
    {"protocol.file.allow",           "always",             "git-config protocol.<name>.allow"},
    {"protocol.ssh.allow",            "always",             "git-config protocol.<name>.allow"},
    {"diff.autoRefreshIndex",         "true",               "git-config diff.autoRefreshIndex: the index is written"},
    {"feature.manyFiles",             "true",               "git-config feature.manyFiles"},
    {"core.untrackedCache",           "true",               "git-config core.untrackedCache"},
    {"core.worktree",                 "$repository",        "git-config core.worktree"},
});

constexpr auto hooks = std::to_array<std::string_view>({
    "applypatch-msg", "pre-applypatch", "post-applypatch", "pre-commit", "pre-merge-commit", "prepare-commit-msg",
    "commit-msg", "post-commit", "pre-rebase", "post-checkout", "post-merge", "pre-push", "pre-receive", "update",
    "proc-receive", "post-receive", "post-update", "reference-transaction", "push-to-checkout", "pre-auto-gc",
    "post-rewrite", "sendemail-validate", "fsmonitor-watchman", "p4-changelist", "p4-prepare-changelist",
    "p4-post-changelist", "p4-pre-submit", "post-index-change",
});
// clang-format on

/// The text of the program as it was is taken away, so that git would fetch it from a remote that promised
/// it.
#define PARTIAL                                                                                              \
    "git config core.repositoryFormatVersion 1; git config extensions.partialClone x; "                      \
    "git config remote.x.promisor true; git config protocol.allow always; "                                  \
    "for p in ext file ssh git http; do git config protocol.$p.allow always; done; "                         \
    "blob=$(git rev-parse HEAD:O1001.nc); "                                                                  \
    "rm -f .git/objects/$(echo $blob | cut -c1-2)/$(echo $blob | cut -c3-); "

constexpr std::string_view lacks_text = "--since lacks 'O1001.nc' as of 'HEAD'";

constexpr auto repositories = std::to_array<HostileRepository>({
    // Where settings may stand: git-config, FILES, INCLUDES; gitrepository-layout; git-worktree.
    {"the settings of the repository", R"(cat "$all" >> .git/config)", ""},
    {"a file that is included", R"(cp "$all" all.cfg; git config include.path ../all.cfg)", ""},
    {"a file outside that is included", R"(git config include.path "$all")", ""},
    {"a file that is included by a condition",
     R"(cp "$all" all.cfg; git config 'includeIf.gitdir:**.path' ../all.cfg)", ""},
    {"the settings of a working tree",
     R"(cp "$all" .git/config.worktree; git config extensions.worktreeConfig true)", ""},
    {"a .git that is a file",
     R"(cat "$all" >> .git/config; mv .git elsewhere; echo 'gitdir: elsewhere' > .git)", ""},
    {"a .git that is a link", R"(cat "$all" >> .git/config; mv .git elsewhere; ln -s elsewhere .git)", ""},
    {"a linked working tree",
     R"(git worktree add -q ../tree; cat "$all" >> .git/config; mv O1001.nc ../tree; cd ../tree)", ""},
    {"hooks", R"(for h in $hooks; do cp "$ran" .git/hooks/$h; done)", ""},
    {"attributes in the working tree", R"(cat "$all" >> .git/config; cp .git/info/attributes .gitattributes)",
     ""},
    {"a git among the programs", R"(for n in git git-ls-tree git-rev-parse git-cat-file; do cp "$ran" $n; done
        PATH=.:$repository:$PATH; export PATH)",
     ""},

    // What is no repository, or not the one of its folder.
    {"a text that is gone", R"(blob=$(git rev-parse HEAD:O1001.nc)
        rm -f .git/objects/$(echo $blob | cut -c1-2)/$(echo $blob | cut -c3-))",
     lacks_text},
    {"files elsewhere", R"(mkdir "$outside/tree"; git config core.worktree "$outside/tree")",
     "by its .git its files lie in"},
    {"files nowhere", R"(git config core.worktree "$outside/nowhere")", "by its .git its files lie in"},
    {"an empty .git", R"(rm -rf .git; mkdir .git)", "it says 'fatal: not a git repository"},
    {"an empty .git inside a repository",
     R"(git init -q ..; rm -rf .git; mkdir .git; cd ..; git add -A; git commit -qm x; cd repository)",
     "it says 'fatal: not a git repository"},
    {"a bare repository around an empty .git", R"(mv .git/* .; rm -rf .git/*)", "it says 'fatal: "},
    {"a .git that names itself", R"(rm -rf .git; echo "gitdir: .git" > .git)", "it says 'fatal: "},
    {"a .git that names nothing", R"(rm -rf .git; echo "gitdir: nowhere" > .git)", "it says 'fatal: "},
    {"a .git that says nothing", R"(rm -rf .git; echo > .git)", "it says 'fatal: "},
    {"a common folder that names itself", R"(echo . > .git/commondir)", ""},
    {"settings that include themselves", R"(git config include.path config)", "--since cannot ask git about"},
    {"settings that are none", R"(echo '[[' > .git/config)", "--since cannot ask git about"},
    {"alternates that name each other", R"(echo ../objects > .git/objects/info/alternates)", ""},
    {"a pipe as HEAD", R"(rm .git/HEAD; mkfifo .git/HEAD)", "HEAD' is a pipe or a device"},
    {"a pipe as the settings", R"(rm .git/config; mkfifo .git/config)", "config' is a pipe or a device"},
    {"a device as the references", R"(ln -s /dev/zero .git/packed-refs)",
     "packed-refs' is a link that leads out"},
    // Their text could come to stand in what git says.
    {"a link as the commits where history ends",
     R"(echo SECRET > "$outside/secret"; ln -s "$outside/secret" .git/shallow)",
     "shallow' is a link that leads out"},
    {"a link as the references",
     R"(echo SECRET > "$outside/secret"; ln -s ../../outside/secret .git/packed-refs)",
     "packed-refs' is a link that leads out"},
    {"a link as HEAD", R"(echo SECRET > "$outside/secret"; ln -sf "$outside/secret" .git/HEAD)",
     "HEAD' is a link that leads out"},
    {"a link as the settings", R"(echo SECRET > "$outside/secret"; ln -sf "$outside/secret" .git/config)",
     "config' is a link that leads out"},
    {"a link to nothing as the grafts", R"(ln -s "$outside/nowhere" .git/info/grafts)",
     "grafts' is a link that leads out"},
    {"a link as the folder of the alternates",
     R"(rm -r .git/objects/info; mkdir "$outside/info"; echo SECRET > "$outside/info/alternates"
        ln -s "$outside/info" .git/objects/info)",
     "objects/info/packs' is a link that leads out"},
    {"a link inside", // git itself takes no HEAD that is a link to what is no reference
     R"(mv .git/config .git/y; ln -s y .git/config)", ""},
    {"references without end",
     R"(git pack-refs --all; seq -f "$(git rev-parse HEAD) refs/tags/t%07g" 300000 >> .git/packed-refs)", ""},
    {"a tree that holds itself ten times in ten levels",
     R"(blob=$(git rev-parse HEAD:O1001.nc); tree=$(printf '100644 blob %s\tx.nc\n' $blob | git mktree)
        for i in 1 2 3 4 5 6 7 8 9 10; do
            tree=$(for j in 0 1 2 3 4 5 6 7 8 9; do printf '040000 tree %s\t%s\n' $tree $j; done | git mktree)
        done
        git update-ref HEAD $(git commit-tree -m x $tree))",
     "has more files than it can hold"},
    {"the settings of another repository in the environment",
     R"(git init -q "$outside/other"; export GIT_DIR="$outside/other/.git" GIT_WORK_TREE="$outside/other"
        export GIT_INDEX_FILE="$outside/other/index" GIT_OBJECT_DIRECTORY="$outside" GIT_CEILING_DIRECTORIES=/)",
     ""},
    {"commands in the environment",
     R"(export GIT_EXTERNAL_DIFF="$ran" GIT_SSH_COMMAND="$ran" GIT_PAGER="$ran" GIT_ASKPASS="$ran"
        export GIT_CONFIG_COUNT=1 GIT_CONFIG_KEY_0=core.fsmonitor GIT_CONFIG_VALUE_0="$ran"
        export GIT_CONFIG_PARAMETERS="'core.fsmonitor'='$ran'" GIT_TRACE="$mark" GIT_TRACE2="$mark"
        export GIT_EXEC_PATH="$outside" GIT_TEMPLATE_DIR="$outside")",
     ""},
});

/// gitremote-helpers, git-config remote.*, partial-clone.
constexpr auto promisors = std::to_array<HostileRepository>({
    {"a promisor that is a command", PARTIAL R"(git config remote.x.url "ext::$ran")", lacks_text},
    {"a promisor whose uploadpack is a command",
     PARTIAL R"(git config remote.x.url "$outside"; git config remote.x.uploadpack "$ran")", lacks_text},
    {"a promisor that ssh leads to",
     PARTIAL R"(git config remote.x.url ssh://nowhere.invalid/x; git config core.sshCommand "$ran")",
     lacks_text},
    {"a promisor that a proxy leads to",
     PARTIAL R"(git config remote.x.url git://nowhere.invalid/x; git config core.gitProxy "$ran")",
     lacks_text},
    {"a promisor that wants a password",
     PARTIAL R"(git config remote.x.url http://127.0.0.1:9/x; git config credential.helper "!$ran"
        git config core.askPass "$ran")",
     lacks_text},
    {"a promisor with a helper of its own",
     PARTIAL R"(mkdir bin; cp "$ran" bin/git-remote-x; PATH=$PATH:$repository/bin; export PATH
        git config remote.x.vcs x; git config remote.x.url y)",
     lacks_text},
    {"a promisor with another name",
     PARTIAL R"(git config remote.x.url far:x; git config "url.ext::$ran .insteadOf" far:)", lacks_text},
    {"a promisor with a command for an empty protocol",
     PARTIAL R"(git config remote.x.url ::x; git config alias.remote- "!$ran")", lacks_text},
    {"a promisor with a command for the protocol that is allowed",
     PARTIAL R"(git config remote.x.vcs no_protocol; git config remote.x.url x)", lacks_text},
});

} // namespace

std::span<const HostileSetting> hostile_settings() { return settings; }
std::span<const std::string_view> hook_names() { return hooks; }
std::span<const HostileRepository> hostile_repositories() { return repositories; }
std::span<const HostileRepository> hostile_promisors() { return promisors; }

} // namespace maclint::test
