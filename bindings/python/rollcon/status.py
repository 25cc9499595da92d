"""Provides statuses as numbers with names."""

from __future__ import annotations

from . import _api


class Status(int):
    """Is a status that a call returned, an integer that shows its name: OK, RIM_CONTACT, ..."""

    @property
    def name(self) -> str:
        return _api.STATUS_NAMES.get(int(self), str(int(self)))

    def __repr__(self) -> str:
        return f"{self.name} ({int(self)})"

    __str__ = __repr__

    def __format__(self, spec: str) -> str:
        return format(int(self), spec) if spec else str(self)
