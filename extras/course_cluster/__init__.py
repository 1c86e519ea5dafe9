"""Grades a class on the workers of a Dask scheduler.

The coordinator (`connect`, `coordinator`) sends submissions as bytes and records the results. A worker
(`worker`) unpacks each submission into a temporary folder and grades it in a separate process. Nothing in a
submission is unpickled or imported on the way: Dask carries text and bytes.
"""
