"""A class graded on the workers of a Dask scheduler.

The coordinator (`connect`, `coordinator`) sends submissions as bytes and records what comes back; a
worker (`worker`) unpacks each into a folder that is gone afterwards, and grades it in a process of its
own. Nothing of a submission is unpickled or imported on the way: Dask carries text and bytes.
"""
