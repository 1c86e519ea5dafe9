"""Renderers: data in, something to read out. Nothing here decides, stores or exits.

Everything that may come from a submission goes through `sanitize` before it reaches a terminal.
"""
