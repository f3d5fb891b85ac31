"""Rules that speak of how a program is written, and why a change may matter to them."""

# change: {rule: reason}
EXEMPT = {
    'comment-at-end': {
        'MAC460': 'a remark behind a jump says that what it passes is passed on purpose',
    },
    'comment-lines': {
        'MAC460': 'blocks with a remark before them are a part of their own behind an end',
    },
    'blank-lines': {
        'MAC460': 'blocks with a free line before them are a part of their own behind an end',
    },
    'small-keywords': {
        'MAC104': 'small letters are what it tells',
    },
    'small-letters': {
        'MAC104': 'small letters are what it tells',
    },
    'capitals': {
        'MAC104': 'small letters are what it tells',
    },
    'renumbered': {
        'MAC302': 'it compares the digits of two numbers: 6 and 60 are alike, 7 and 61 are not',
        'MAC341': 'remarks keep the numbers that they name',
    },
}

# Of these only the lines are compared where blanks have changed.
TELLS_A_PIECE = {
    'MAC121': 'it quotes the piece at which reading broke off, and counts blocks with the same piece together',
}


def is_exempt(change, code):
    return code in EXEMPT.get(change, {})
