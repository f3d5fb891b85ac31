"""Operands of Fanuc programs for which an operation has no value."""
import re

from .edit import put
from .flow import unreached

DIVISOR = re.compile(r'[\]\d.]\s*/\s*(\d+\.?\d*)(?![\d.])')
TANGENT = re.compile(r'(?<![A-Z])TAN\s*\[\s*(\d+\.?\d*)\s*\]')
ROOT = re.compile(r'SQRT\s*\[\s*(\d+\.?\d*)\s*\]')


def plants(program):
    for index, block in enumerate(program.blocks):
        reason = unreached(program, index)
        divisor = DIVISOR.search(block.code)
        if divisor:
            undecided = 'the condition may be decided before' if re.search(r'\b(?:AND|OR)\b', block.code) else ''
            yield 'divisor-zero', put(block, divisor.span(1), '0'), reason or undecided
        angle = TANGENT.search(block.code)
        if angle:
            yield 'tangent-right-angle', put(block, angle.span(1), '90.'), reason
        root = ROOT.search(block.code)
        if root:
            yield 'root-negative', put(block, root.span(1), '-' + root.group(1)), reason
