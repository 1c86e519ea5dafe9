"""Verbs: one package for each command, one module for each verb. See README.md."""
