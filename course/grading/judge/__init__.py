"""Recordings judged by the graders as they are now, in processes of their own. Needs no ROS.

judges.py           `Judge` for one recording after another, `rejudge` for many, from several processes
judging_process.py  what runs in such a process
plugin.py           one pytest session in it
regraded.py         from a judgment to a submission's new result, and what has moved
"""
