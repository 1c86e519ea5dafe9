"""Runs in namespaces of its own: starts a driver (JSON), then the program, and ends as that does."""

from __future__ import annotations

import json
import subprocess
import sys


def main() -> int:
    driver, program = json.loads(sys.argv[1]), sys.argv[2:]
    with subprocess.Popen(driver, stdout=sys.stderr) as running:
        try:
            return subprocess.run(program, check=False, timeout=120).returncode
        finally:
            running.kill()


if __name__ == "__main__":
    sys.exit(main())
