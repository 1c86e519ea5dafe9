"""Doubles itself as often as it can. MOST: after that many generations it would stop by itself."""

import os
import time

for generation in range(MOST):
    try:
        os.fork()
    except OSError:
        time.sleep(0.01)
