"""Runs the program until its first line, interrupts it, prints its other lines, and ends as it does."""

from __future__ import annotations

import signal
import subprocess
import sys


def main() -> int:
    with subprocess.Popen(sys.argv[1:], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        process.stdout.readline()
        process.send_signal(signal.SIGINT)
        print(process.stdout.read(), end="")
    return process.returncode


if __name__ == "__main__":
    sys.exit(main())
