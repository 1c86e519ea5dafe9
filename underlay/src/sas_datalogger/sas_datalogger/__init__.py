"""Sends values to the node that logs them, from Python."""

from sas_datalogger.client import DataloggerClient

__all__ = ["DataloggerClient"]
