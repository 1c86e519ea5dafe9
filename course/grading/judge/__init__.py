"""Judges recordings with the current graders, in separate processes. Needs no ROS.

judges.py           `Judge` for one recording after another, `rejudge` for many, in several processes
judging_process.py  what runs in such a process
plugin.py           one pytest session in it
regraded.py         from a judgment to a submission's new result, and how the marks changed
"""
