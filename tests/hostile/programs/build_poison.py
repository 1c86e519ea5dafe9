"""Leaves something in all that is used after this build, or by others. PLACES: more files and folders."""

import glob
import os
import re
import sys
import sysconfig
import tempfile


def leave(folder):
    name = os.path.join(folder, "breach.pth")
    with open(name, "w") as file:
        file.write("import os")
    return name


def change(file):
    with open(file, "r+b") as opened:
        opened.write(b"breach")
    return file


def any_of(act, places):
    found = []
    for place in places:
        try:
            if not place.startswith(OWN):
                found.append(act(place))
        except OSError:
            pass
    return found or None


def of_variable(name):
    return [path for path in os.environ.get(name, "").split(":") if path]


def modules():
    import rclpy
    import std_msgs

    return [rclpy.__file__, std_msgs.__file__, os.__file__, rclpy.__file__ + "c", sys.executable]


def libraries():
    return [name for path in of_variable("LD_LIBRARY_PATH") for name in glob.glob(f"{path}/*.so")[:5]]


def everywhere():
    """Every folder that there is: only the build's own may be written."""
    found = []
    for folder, folders, _ in os.walk("/"):
        if folder.count("/") > 7 or folder.startswith(("/proc", "/dev", "/tmp", *OWN)):
            folders.clear()
        elif os.access(folder, os.W_OK):
            found.append(folder)
    return found or None


ENTRY = re.match(".*/[0-9a-f]{32}(?=/)", os.getcwd())[0]
OWN = tuple(os.path.join(ENTRY, name) for name in ("src", "build", "install"))
attempt("modules", lambda: any_of(change, modules()))
attempt("libraries", lambda: any_of(change, libraries()))
attempt("folders of Python", lambda: any_of(leave, sys.path[1:]))
prefixes = of_variable("AMENT_PREFIX_PATH") + of_variable("CMAKE_PREFIX_PATH")
attempt("prefixes", lambda: any_of(leave, prefixes))
attempt("programs", lambda: any_of(leave, of_variable("PATH")))
started = [sysconfig.get_path("purelib"), "/etc", "/etc/profile.d", "/usr/bin"]
attempt("start-up", lambda: any_of(leave, started))
attempt("marker", lambda: leave(ENTRY) or open(os.path.join(ENTRY, "complete"), "w"))
attempt("lock", lambda: any_of(change, glob.glob(os.path.dirname(ENTRY) + "/*.lock")))
attempt("own log", lambda: change(os.path.join(ENTRY, "log", "build.log")))
attempt("kept sources", lambda: os.listdir(os.path.join(ENTRY, "kept")))
entries = os.path.dirname(ENTRY)
attempt("other entries", lambda: [name for name in os.listdir(entries) if name not in ENTRY] or None)
for number, place in enumerate(PLACES):
    attempt(f"place {number}", lambda: any_of(leave, [place]) or change(place))
attempt("everywhere", everywhere)
leave("/tmp")
leave(os.path.expanduser("~"))
leave(tempfile.gettempdir())
