"""Keeps every core busy, with as many processes as are let. PROCESSES: how many."""

import os


def realtime():
    os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(50))
    return os.sched_getscheduler(0) or None


attempt("realtime", realtime)
for number in range(PROCESSES):
    if os.fork() == 0:
        while True:
            pass
