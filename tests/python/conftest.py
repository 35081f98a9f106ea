# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The sea that the tests of the wrapper look at."""

import pytest

import libocean

SMALL = """
libocean = 1
[grid]
resolution = 64
patch_size = 200.0
[[waves]]
spectrum = "jonswap"
wind_speed = 12.0
wind_direction = 30.0
"""


@pytest.fixture
def sea():
    with libocean.parse(SMALL) as small:
        yield small
