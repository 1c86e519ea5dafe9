"""Begins every hostile program: tells what came of an attempt, and lets nothing stop the program."""

import threading


def attempt(name, act):
    """Whatever `act` returns is a breach; that it raises, or returns None, means that it was held off."""
    try:
        found = act()
    except BaseException as error:
        print(f"HELD {name}: {type(error).__name__} {str(error)[:100]!r}", flush=True)
        return
    if found is None:
        print(f"HELD {name}: nothing", flush=True)
    else:
        print(f"BREACH {name}: {str(found)[:200]!r}", flush=True)


def aside(act):
    """Let it go on while the node does what is right."""
    threading.Thread(target=act, daemon=True).start()
