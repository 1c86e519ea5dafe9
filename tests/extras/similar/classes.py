"""Programs for small classes: two that do the same in different ways, and copies of them."""

from __future__ import annotations

from pathlib import Path

SHOP = '''\
"""A shop."""

import json


class Shop:
    def __init__(self, path, currency="EUR"):
        self.path = path
        self.items = {}
        self.currency = currency

    def load(self):
        with open(self.path) as file:
            for row in json.load(file):
                self.items[row["name"]] = float(row["price"]) * 1.2

    def total(self, basket):
        total = 0
        for name, count in basket.items():
            if name not in self.items:
                raise KeyError(f"there is no {name}")
            total += self.items[name] * count
        return round(total, 2)

    def cheapest(self):
        if not self.items:
            return None
        return min(self.items, key=lambda name: (self.items[name], name))
'''
GARDEN = """\
from dataclasses import dataclass, field
from statistics import mean


@dataclass
class Bed:
    plants: list = field(default_factory=list)
    dry: bool = True


def water(beds, liters):
    while liters > 0 and any(bed.dry for bed in beds):
        bed = next(bed for bed in beds if bed.dry)
        bed.dry, liters = False, liters - len(bed.plants)
    return liters


def describe(beds):
    sizes = sorted({len(bed.plants) for bed in beds}, reverse=True)
    print("beds:", len(beds), "mean:", mean(sizes or [0]), sep="\\t")
    try:
        largest = sizes[0]
    except IndexError:
        return "no beds"
    return f"largest {largest:>4}" if largest else "all empty"
"""
RENAMED = (
    SHOP.replace("self", "me")
    .replace("Shop", "Store")
    .replace("items", "goods")
    .replace("total", "amount")
    .replace("basket", "cart")
    .replace('"there is no', "'sorry, no")
    .replace('{name}")', "{name}')")
    .replace('"""A shop."""', "# All my own work\n")
    .replace("\n    def ", "\n\n    # What it does is plain.\n    def ")
)


def write(file: Path, content: str | bytes) -> Path:
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(content if isinstance(content, bytes) else content.encode("utf-8", "surrogateescape"))
    return file


def hand_in(folder: Path, name: str, content: str | bytes, file: str = "shop.py") -> Path:
    """A package with one program, handed in by `name`."""
    package = folder / name / "src" / "shop"
    write(package / "package.xml", "<package><name>shop</name></package>")
    return write(package / "shop" / file, content)
