"""Changes of blocks. Lines are only added within the text of a line: then those after it are counted without them."""


def put(block, span, text):
    """(line, columns, text): the columns of the block's line are replaced."""
    return [(block.line, span, text)]


def drop(block):
    """The block without its words; a sequence number stays, because something may jump to it."""
    head = 0
    if block.label is not None:
        head = block.code.index(str(block.label), block.code.index('N')) + len(str(block.label))
    return [(block.line, (head, len(block.code.rstrip())), '')]


def apply(lines, edits):
    """The changed lines by number."""
    changed = {}
    for line, (begin, end), text in sorted(edits, key=lambda edit: (edit[0], -edit[1][0])):
        old = changed.get(line, lines[line])
        changed[line] = old[:begin] + text + old[end:]
    return changed


def exchange(lines, first, second):
    return {first: lines[second], second: lines[first]}
