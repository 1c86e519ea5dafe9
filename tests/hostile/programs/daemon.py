"""Leaves a process behind that left its session, its terminal and its parent. WORK: what it does there."""

import os
import signal
import time

if os.fork() == 0:
    os.setsid()
    if os.fork():
        os._exit(0)
    os.closerange(0, 1024)
    os.chdir("/")
    for number in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT):
        signal.signal(number, signal.SIG_IGN)
    while True:
        if os.fork() == 0:  # a new pid all the time
            time.sleep(0.05)
        else:
            time.sleep(0.05)
            os._exit(0)
