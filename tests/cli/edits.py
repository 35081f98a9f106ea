# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Small edits that make a good file a broken one."""


def replaced(content: bytes, old: bytes, new: bytes) -> bytes:
    """The first `old` replaced; it must be there."""
    assert old in content, old
    return content.replace(old, new, 1)


def first_lines(content: bytes, count: int) -> bytes:
    return b"".join(content.splitlines(keepends=True)[:count])


def without_line(content: bytes, number: int) -> bytes:
    """All lines but one, counted from 1."""
    every = content.splitlines(keepends=True)
    return b"".join(every[: number - 1] + every[number:])
