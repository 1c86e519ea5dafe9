"""Reads every file that can be seen, and finds those of the course. KNOWN: digests of their texts and of
their lines (see `tests.hostile.secrets`); LENGTHS: how many bytes the texts have; SHORTEST, LINES: of how
many bytes a line is, and how many of them are no accident; FROM: names that show that the walk got around.
SKIPPED: folders. MOST_TEXT: up to how many bytes a file is also compared by lines. Ends with an error when
it found anything.
"""

import hashlib
import os
import stat
import sys
import sysconfig

# Too many to read, and of others: there, files of the right length are compared as a whole.
SYSTEM = ("/usr/", sysconfig.get_path("stdlib") + "/", sysconfig.get_path("include") + "/")
PYTHON = ("/site-packages/", "/dist-packages/")


def digest(data):
    return hashlib.sha256(data).hexdigest()[:10]


def visible():
    for folder, folders, files in os.walk("/"):
        folders[:] = [] if folder in SKIPPED else folders
        yield from (os.path.join(folder, name) for name in files)


def found_in(path):
    """What of the course the file holds, or None."""
    status = os.stat(path)
    whole = status.st_size in LENGTHS
    by_line = status.st_size < MOST_TEXT and (
        not path.startswith(SYSTEM) or any(part in path for part in PYTHON)
    )
    if not stat.S_ISREG(status.st_mode) or not (whole or by_line):
        return None
    with open(path, "rb") as file:
        data = file.read()
    if whole and digest(data) in KNOWN:
        return "the whole file"
    lines = (line.strip() for line in data.splitlines()) if by_line else ()
    known = {line for line in lines if len(line) >= SHORTEST and digest(line) in KNOWN}
    return known if len(known) >= LINES else None


def walk():
    found, seen = [], set()
    for path in visible():
        seen.add(os.path.basename(path))
        if path.startswith(OWN):
            continue
        try:
            what = found_in(path)
        except OSError:
            what = None
        if what is not None:
            found.append(f"{path}: {str(what)[:90]}")
    missing = set(FROM) - seen
    return found[:20] + [f"the walk missed {name}" for name in missing] or None


KNOWN = set(KNOWN.split())
OWN = (os.path.expanduser("~") + "/", os.getcwd() + "/")
found = walk()
attempt("walk", lambda: found)
if found:
    sys.exit(f"BREACH walk: {found}")
