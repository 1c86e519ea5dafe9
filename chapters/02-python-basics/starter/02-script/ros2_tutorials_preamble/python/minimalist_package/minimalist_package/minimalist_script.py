# TODO 1: the very first line of this file says that python3 shall read it.

# TODO 2: import what you need in order to wait.


# TODO 3: main prints "Howdy!" twice per second, for ever, and ends quietly on
#   Ctrl+C. Say after its brackets what it returns.
def main():
    """Say Howdy."""
    print("minimalist_script.py does nothing yet.")


# TODO 4: call main, but only when this file is run, and not when it is imported.
main()
