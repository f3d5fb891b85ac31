"""Questions about the paths of a Fanuc program."""
import re

from .fanuc import ARGUMENTS, CALL, VARIABLE

VACANCY_TEST = r'#\s*0*{0}\s*(?:EQ|NE)\s*#\s*0(?!\d)|#\s*0\s*(?:EQ|NE)\s*#\s*0*{0}(?!\d)'


def unreached(program, index):
    """The reason why a place is none."""
    return '' if index in program.reachable else 'no path leads to this block'


def reads_arguments(program):
    """Whether a block reads what a letter passes, and no block above has set it."""
    stored = set()
    for block in program.blocks:
        if any(variable in ARGUMENTS - stored for variable, _ in block.reads):
            return True
        stored |= set(block.stores)
    return False


SHARED = 'the program takes no argument: M98 may call it, and its caller may have set the variable'


def may_share_locals(program):
    """Without arguments a program that returns may be called by M98, and see what its caller has set."""
    return program.returns and not reads_arguments(program)


def tests_vacancy(block, variable):
    return re.search(VACANCY_TEST.format(variable), block.code) is not None


def uses(block, variable):
    """Whether it matters in this block that the variable is vacant: not in a test for that, a copy or an argument."""
    if variable not in [read for read, _ in block.reads]:
        return False
    if tests_vacancy(block, variable) and sum(read == variable for read, _ in block.reads) == 1:
        return False
    if re.search(rf'=\s*#\s*0*{variable}\s*$', block.code.rstrip()):
        return False
    return not CALL.search(block.code)


def may_store(block, variable):
    return variable in block.stores or block.stores_anywhere or block.uses_frame_of_caller


def certainly_stores(block, variable):
    return variable in block.stores and not block.conditional and not block.skipped


def vacant_uses(program, variable, without=None):
    """Blocks that use the variable and that a path without a store of it leads to. `without`: the block whose store is gone."""
    def stores(index):
        return index != without and may_store(program.blocks[index], variable)

    return {index for index in program.reach([0], stores) if uses(program.blocks[index], variable)}


def live_uses(program, index, variable):
    """Blocks after this one that use what the variable holds there."""
    starts = program.successors[index]
    reached = program.reach(starts, lambda at: certainly_stores(program.blocks[at], variable))
    return {at for at in reached if uses(program.blocks[at], variable)}


def variables_in(code):
    return {int(number) for number in VARIABLE.findall(code)} - {0}


def is_trap(program, successors, index):
    """Whether no block that the control can come to from here lets it leave or stop."""
    seen, waiting = {index}, [index]
    while waiting:
        at = waiting.pop()
        if program.has_exit(at):
            return False
        for after in successors(at):
            if after not in seen:
                seen.add(after)
                waiting.append(after)
    return True
