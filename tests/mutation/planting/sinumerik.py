"""Defects of SINUMERIK programs: slips in whole ones that are clean."""
from . import sinumerik_calls, sinumerik_flow, sinumerik_names, sinumerik_state, sinumerik_text, sinumerik_words
from .sinumerik_reader import Program

WHOLE = {'.mpf', '.spf'}  # an archive holds several programs, a file of definitions none


def program_of(path, lines):
    return Program(path.stem, lines, path.suffix.lower() == '.mpf')


def plants(program, libraries, shared):
    """(class, edits, why it is harmless). `libraries`: the programs that are read together, by name. `shared`: the names that
    files of definitions beside it define."""
    yield from sinumerik_text.plants(program)
    yield from sinumerik_names.plants(program, shared)
    yield from sinumerik_flow.plants(program, libraries)
    yield from sinumerik_calls.plants(program, libraries)
    yield from sinumerik_state.plants(program, libraries)
    yield from sinumerik_words.plants(program)


def names_of(path, lines):
    """What a file is called by: its name, and what a file of definitions defines."""
    program = program_of(path, lines)
    macros = {block.text.split()[1] for block in program.blocks if block.text.startswith('DEFINE ')}
    return {program.name} | (set(program.variables) | macros if path.suffix.lower() == '.def' else set())


def named_in(path, lines):
    return program_of(path, lines).named
