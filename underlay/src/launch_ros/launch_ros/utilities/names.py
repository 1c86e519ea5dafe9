"""Names of nodes and namespaces."""

from __future__ import annotations


def joined_namespace(base: str | None, own: str | None) -> str | None:
    """`own` below `base`; one with a slash in front stands for itself."""
    if base is None or (own is not None and own.startswith("/")):
        return own
    if not own:
        return base
    return f"{base.rstrip('/')}/{own}"


prefix_namespace = joined_namespace


def absolute_namespace(namespace: str) -> str:
    return "/" + namespace.strip("/")


def make_namespace_absolute(namespace: str | None) -> str | None:
    return None if namespace is None else absolute_namespace(namespace)


def full_name(namespace: str, name: str) -> str:
    return f"{namespace.rstrip('/')}/{name}"
