"""Reads what is none of its business. PLACES: files and folders; SECRET: what the canaries hold."""

import glob
import os


def read(place):
    if os.path.isdir(place):
        names = os.listdir(place)
        return names if any(SECRET in name for name in names) else None
    with open(place, "rb") as file:
        return file.read(4000) or None


def search(top):
    """Some canary below this folder; the system's own files are too many, and nobody's secret."""
    for folder, folders, files in os.walk(top):
        if folder in ("/proc", "/usr") or folder.endswith(("site-packages", "/lib", "/include")):
            folders.clear()
        for name in (*folders, *files):
            if SECRET in name:
                return os.path.join(folder, name)
    return None


def environments():
    """Of processes that this program did not start: what they were given, and where they are."""
    found = []
    for pid in filter(str.isdigit, os.listdir("/proc")):
        for name in ("environ", "maps", "mem", "cwd", "root", "exe", "auxv", "stack"):
            try:
                if int(pid) != os.getpid():
                    with open(f"/proc/{pid}/{name}", "rb") as file:
                        file.read(100)
                    found.append((pid, name))
            except OSError:
                pass
    return found or None


def command_lines():
    """Whatever tells where something lies."""
    found = []
    for file in glob.glob("/proc/*/cmdline"):
        with open(file, "rb") as lines:
            text = lines.read().decode(errors="replace")
        if any(word in text for word in ("seed", "evidence", "grading", SECRET)):
            found.append(text)
    return found or None


def descriptors():
    """Pipes and files of others."""
    found = []
    for link in glob.glob("/proc/[0-9]*/fd/*") + glob.glob("/proc/[0-9]*/task/*/fd/*"):
        try:
            if f"/{os.getpid()}/" not in link:
                os.close(os.open(link, os.O_RDWR | os.O_NONBLOCK))
                found.append(link)
        except OSError:
            pass
    return found or None


def own_descriptors():
    """Anything that was left open for it, beside its terminal."""
    known = {os.readlink(f"/proc/self/fd/{number}") for number in (0, 1, 2)}
    found = []
    for number in os.listdir("/proc/self/fd"):
        try:
            leads_to = os.readlink(f"/proc/self/fd/{number}")
        except OSError:  # the one that listed the folder
            continue
        if leads_to not in known:
            found.append(leads_to)
    return found or None


def passwords():
    with open("/etc/passwd") as file:
        lines = file.read().splitlines()
    return lines if {line.split(":")[0] for line in lines} != {"root", "learner"} else None


def secrets_in_environment():
    return [key for key in os.environ if "SECRET" in key.upper() or SECRET in os.environ[key]] or None


# Before anything else is imported: rclpy opens what it needs.
attempt("own descriptors", own_descriptors)
for number, place in enumerate(PLACES):
    attempt(f"place {number}", lambda: read(place))
for act in (environments, command_lines, descriptors, passwords, secrets_in_environment):
    attempt(act.__name__, act)
attempt("search", lambda: search("/"))
