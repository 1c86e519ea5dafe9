"""Writes, removes and renames what is not its own. PLACES: files; FOLDERS: where to leave something."""

import os
import sys
import tempfile


def overwrite(place):
    with open(place, "r+b") as file:
        file.write(b"breach")
    return "written"


def leave(folder):
    name = os.path.join(folder, "breach")
    with open(name, "wb") as file:
        file.write(b"breach")
    return name


def remove(place):
    os.unlink(place)
    return "removed"


def rename(place):
    os.rename(place, place + ".breach")
    return "renamed"


def change_mode(place):
    os.chmod(place, 0o777)
    return "changed"


def link(place):
    os.link(place, "/tmp/breach-link")
    return "linked"


def own_install():
    """The program that runs here: the next learner's, if it could be changed."""
    for folder in {os.path.dirname(os.path.abspath(__file__)), *filter(os.path.isdir, sys.path)}:
        try:
            return leave(folder)
        except OSError:
            pass
    return overwrite(__file__)


def interpreters():
    """Bytecode, and start-up files of every Python."""
    for folder in (sys.prefix, os.path.dirname(os.__file__), "/etc", "/usr/bin", "/etc/profile.d", "/root"):
        try:
            return leave(folder)
        except OSError:
            pass
    return None


for number, place in enumerate(PLACES):
    for act in (overwrite, remove, rename, change_mode, link):
        attempt(f"{act.__name__} {number}", lambda: act(place))
for number, folder in enumerate(FOLDERS):
    attempt(f"leave {number}", lambda: leave(folder))
attempt("own_install", own_install)
attempt("interpreters", interpreters)
# Where it may write is private: the proof looks for this name in the real folders.
for folder in ("/tmp", "/dev/shm", tempfile.gettempdir(), os.path.expanduser("~")):
    leave(folder)
