"""Keeps every core busy, with as many processes as are let. PROCESSES: how many."""

import os

attempt('realtime', lambda: os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(50)) or 'got it')
for number in range(PROCESSES):
    if os.fork() == 0:
        while True:
            pass
