"""DIN PLUS programs in pieces: what a change may touch, and what not."""
import re

from .text import pieces_of

COMMENT = '[K]'

# A section word, an entry of the program head and the name of the program are texts; so are foreign comments.
TOKEN = re.compile(r'''
    (?P<comment>\[[^\]]*\]?)
  | (?P<fixed>"[^"\r\n]*"? | \xe2\x80[\x9c-\x9e](?:(?!\xe2\x80[\x9c-\x9e])[^"\r\n])*(?:"|\xe2\x80[\x9c-\x9e])? | (?:;|//)[^\r\n\[]*
      | (?:(?<=[\r\n])|(?<![\s\S]))[ \t]*(?:[%]|\#[A-Z\x80-\xff]{2})[^\r\n\[]*
      | \([ \t]*[A-Za-z][^()\r\n\#]*[ ][^()\r\n\#]*\)
      | [\000\f\v\x1a]+
      | (?i:N?DEF|DVDEF)[ \t]*\([^()\r\n]*\)
      | \#[ \t]*[A-Za-z_0-9]* | _\w*
      | [?][<>]? | [<>=!]=|=[<>]|<>|><)
  | (?P<end>\r\n|\n\r*|\r)
  | (?P<blank>[ \t]+)
  | (?P<letters>[A-Za-z_\x80-\xff]+)
  | (?P<number>[0-9.]+)
  | (?P<sign>.)''', re.VERBOSE)


def pieces(text):
    return pieces_of(text, TOKEN, lambda match: match.lastgroup)
