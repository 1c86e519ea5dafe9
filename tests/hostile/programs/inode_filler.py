"""Makes files without end that hold nothing."""

import os
import tempfile

number = 0
while True:
    try:
        os.close(os.open(os.path.join(tempfile.gettempdir(), f"breach-{number}"), os.O_CREAT))
    except OSError:
        pass
    number += 1
