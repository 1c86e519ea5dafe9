# TODO 1: make the very first line of this file name python3 as the program that reads it.

# TODO 2: import what you need in order to wait.


# TODO 3: main prints "Howdy!" twice per second, forever, and ends without a traceback
#   on Ctrl+C. Add its return type after the parentheses.
def main():
    """Say Howdy."""
    print("minimalist_script.py does nothing yet.")


# TODO 4: call main only when this file is run, not when it is imported.
main()
