"""Renderers: they turn data into something to read. Nothing here decides, stores or exits.

Everything that may come from a submission goes through `sanitize` before it reaches a terminal.
"""
