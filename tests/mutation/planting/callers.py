"""Whether the known callers of a Fanuc program are hurt by what it leaves behind."""
import re

from .fanuc import CALL, NUMBER_CALLED, PROGRAM_END, RETURN

MOVES = re.compile(r'(?<![A-Z])[XYZABCUVW]\s*[-#\[\d.]')
FEED_MOVES = re.compile(r'G\s*0*[123](?![\d.])|(?<![A-Z])[XYZ]\s*[-#\[\d.]')
RAPID = re.compile(r'G\s*(?:28|30)(?![\d.])')  # whatever the feed is
# For each class of leftovers: what says the mode anew, and what is hurt when nothing has.
NEEDS = {
    'mode-left': (re.compile(r'G\s*(?:9[01]|1[789])(?![\d.])|G\s*#'), MOVES),
    'feed-left': (re.compile(r'(?<![A-Z])F\s*[#\[\d.]|G\s*0*0(?![\d.])'), FEED_MOVES),
    'speed-left': (re.compile(r'(?<![A-Z])S\s*[#\[\d.]|M\s*0*5(?!\d)'), MOVES),
}
DEPTH = 6


class Callers:
    """The programs of some files, by number."""

    def __init__(self, programs):
        numbered = [program for program in programs if program.number is not None]
        self.by_number = {program.number: program for program in numbered}
        self.several = {program.number for program in numbered if self.by_number[program.number] is not program}

    def of(self, number):
        for program in self.by_number.values():
            for index, block in enumerate(program.blocks):
                called = NUMBER_CALLED.search(block.code) if block.is_call else None
                if called and int(called.group(1)) == number and index in program.reachable:
                    yield program, index

    def of_one_control(self, called):
        """Callers that surely mean this program: no other has its number, and none of the two folders stands beside the
        other, as those of two machines do."""
        for program, index in self.of(called.number) if called.number not in self.several else ():
            folders = {program.folder, called.folder}
            if len(folders) == 1 or any(folder in other.parents for folder in folders for other in folders):
                yield program, index

    def none_is_hurt(self, kind, number):
        """Callers are known, and each says the mode anew before it needs it."""
        callers = list(self.of(number))
        return bool(callers) and not any(self.is_hurt(kind, program, program.successors[index], DEPTH) for program, index in callers)

    def is_hurt(self, kind, program, starts, depth):
        anew, needs = NEEDS[kind]
        seen, waiting = set(starts), list(starts)
        while waiting:
            index = waiting.pop()
            block = program.blocks[index]
            if CALL.search(block.code):
                called = NUMBER_CALLED.search(block.code)
                callee = self.by_number.get(int(called.group(1))) if called else None
                if callee is None or not depth:
                    continue  # nobody knows what it does
                if self.is_hurt(kind, callee, [0], 0):
                    return True
            elif anew.search(block.code):
                continue
            elif needs.search(block.code) and '=' not in block.code and not RAPID.search(block.code):
                return True
            if depth and RETURN.search(block.code) and not PROGRAM_END.search(block.code):
                outer = list(self.of(program.number)) if depth > 1 else []
                if any(self.is_hurt(kind, caller, caller.successors[at], depth - 1) for caller, at in outer):
                    return True
            for after in program.successors[index]:
                if after not in seen:
                    seen.add(after)
                    waiting.append(after)
        return False
