# What .ci/run is made of: steps with their verdicts, the hour that they share, and what a change is compared with.

passed=0 failed=0 skipped=0 verdicts=()

# step NAME FUNCTION: a function returns 0 for passed, 77 for skipped (its reason in $reason), else it failed.
step() {
    local name=$1 began=$SECONDS status verdict
    shift
    reason=
    printf '\n== %s\n' "$name"
    "$@"
    status=$?
    case $status in
        0) passed=$((passed + 1)) verdict=passed ;;
        77) skipped=$((skipped + 1)) verdict="skipped: $reason" ;;
        *) failed=$((failed + 1)) verdict="FAILED (status $status)" ;;
    esac
    verdicts+=("$(printf '%-34s %s, %d s' "$name" "$verdict" $((SECONDS - began)))")
    printf '== %s\n' "${verdicts[-1]}"
}

skip() {
    reason=$1
    return 77
}

# within SECONDS MOST COMMAND...: skipped where less than SECONDS are left of the hour, or where it does not end in what
# is left: a slow machine then does less, not the same in two hours. What does not end in MOST seconds hangs, and has failed.
hour=3400
within() {
    local wanted=$1 most=$2 left=$((hour - SECONDS)) limit status=0
    shift 2
    ((left >= wanted)) || { skip "only $((left > 0 ? left / 60 : 0)) minutes are left of the hour; ./dev release does it" || return; }
    limit=$((most < left ? most : left))
    timeout "$limit" "$@" || status=$?
    ((status == 124)) || return "$status"
    ((limit == most)) || { skip "it did not end within the hour; ./dev release does it" || return; }
    echo "stopped after $most seconds: it hangs, or this machine is far too slow"
    return "$status"
}

has() { command -v "$1" >/dev/null; }

# shown_if_failed STATUS LOG: hands the status on.
shown_if_failed() {
    (($1 == 0 || $1 == 77)) || tail -n 200 "$2"
    return "$1"
}

# unchanged FOLDER COMMAND...: after the command git sees no difference in the folder.
unchanged() {
    local folder=$1
    shift
    git rev-parse --is-inside-work-tree >/dev/null || { skip 'this is not a git checkout' || return; }
    "$@" || return 1
    [[ -n $(git status --porcelain -- "$folder") ]] || return 0
    git status --short -- "$folder"
    git --no-pager diff --stat -- "$folder"
    return 1
}

# Puts into `base` what a change is compared with: MACLINT_BASE; on a branch where it left origin; else twenty commits
# back. Skipped outside of a checkout, failed where MACLINT_BASE names no commit.
find_base() {
    git rev-parse --is-inside-work-tree >/dev/null 2>&1 || { skip 'this is not a git checkout: what has changed is not known' || return; }
    if [[ -n ${MACLINT_BASE:-} ]]; then
        base=$(git rev-parse --verify --quiet "$MACLINT_BASE^{commit}") ||
            { echo "MACLINT_BASE names no commit that is here: '$MACLINT_BASE'"; return 1; }
    else
        base=$(git merge-base HEAD origin/HEAD 2>/dev/null || git merge-base HEAD origin/main 2>/dev/null)
    fi
    [[ -n $base && $base != $(git rev-parse HEAD) ]] || base=$(git rev-parse --verify --quiet HEAD~20) ||
        base=$(git rev-list --max-parents=0 HEAD | tail -n 1)
}
