# SPDX-License-Identifier: BSD-3-Clause
"""A record's file as bytes or as text."""
import os

from drill_rig_sim.field.table import RecordError
from drill_rig_sim.text_file import TextError, decoded

MOST_BYTES = 2**30


def begins_with(file, sign):
    """Whether the first byte of a regular file that is neither blank nor part of a byte order mark is this one."""
    if not os.path.isfile(file):
        return False  # the reader of texts says why
    try:
        with open(file, "rb") as opened:
            return opened.read(4096).lstrip(b"\xef\xbb\xbf\xff\xfe \t\r\n\0")[:1] == sign
    except OSError as error:
        raise RecordError("%s: %s" % (file, error.strerror))


def bytes_of(file):
    try:
        if os.path.getsize(file) > MOST_BYTES:
            raise RecordError("%s: is larger than 1 GiB" % file)
        with open(file, "rb") as opened:
            return opened.read()
    except OSError as error:
        raise RecordError("%s: %s" % (file, error.strerror))


def text_of(file):
    """A file's text, and lines on its encoding."""
    try:
        text, remark = decoded(file, MOST_BYTES)
    except TextError as error:
        raise RecordError(str(error))
    return text, [remark] if remark else []
