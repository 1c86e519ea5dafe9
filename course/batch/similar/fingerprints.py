"""Fingerprints of a sequence of words by winnowing, as the library `scanoss-winnowing` does it.

The library winnows texts of digits and letters: 30 of them make a fingerprint, of each 64 neighbours one
is kept. With three for each word, any 31 words that two programs share give them a fingerprint in common.
"""

from __future__ import annotations

import re
import shlex
import sys
from collections.abc import Callable
from itertools import product
from string import ascii_lowercase, digits

from course.batch.similar.words import number_of
from course.errors import MissingHere

LIBRARY = "scanoss-winnowing>=0.8,<1"
SHORTEST = 31  # words; fewer have no fingerprint
_DIGITS = tuple("".join(three) for three in product(digits + ascii_lowercase, repeat=3))
_FINGERPRINT = re.compile(r"\b[0-9a-f]{8}\b")

Fingerprinter = Callable[[str], frozenset[str]]


def fingerprinter() -> Fingerprinter:
    """What takes words (`Words.text`, or a stretch of it) and gives their fingerprints.

    Raises MissingHere when the library is not installed.
    """
    try:
        from scanoss_winnowing.winnowing import Winnowing
    except ImportError:
        what = "Comparing submissions needs a library that is not installed: scanoss-winnowing."
        step = f'`{shlex.quote(sys.executable)} -m pip install "{LIBRARY}"` gets it.'
        raise MissingHere(what, step) from None
    winnowing = Winnowing(quiet=True, all_extensions=True)

    def fingerprints(words: str) -> frozenset[str]:
        coded = "".join(_DIGITS[number_of(word)] for word in words)
        # Its first line is about the file, with a hash of it; the others are fingerprints.
        _, _, found = winnowing.wfp_for_contents("", False, coded.encode()).partition("\n")
        return frozenset(_FINGERPRINT.findall(found))

    return fingerprints
