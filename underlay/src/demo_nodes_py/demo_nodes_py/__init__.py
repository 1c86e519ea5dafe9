"""Nodes for trying things out."""
