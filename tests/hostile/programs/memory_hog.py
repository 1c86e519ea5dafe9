"""A list that grows without end, in several processes at once. PROCESSES: how many more."""

import os

for number in range(PROCESSES):
    if os.fork() == 0:
        break
hoard = []
while True:
    hoard.append(os.urandom(1024) * 4096)
