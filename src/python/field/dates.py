"""Dates with a time of the day as records write them, in seconds since 1970 UTC."""
import re
from datetime import datetime, timedelta, timezone

ISO = re.compile(r"(\d{4})([-/])(\d\d?)\2(\d\d?)[T ]+(\d\d?):(\d\d)(?::(\d\d)(?:[.,](\d+))?)?\s*(Z|UTC|[+-]\d\d:?\d\d)?$", re.IGNORECASE)
FORMS = 'ISO 8601 such as 2017-07-31T23:59:00Z, or a format: {column: ..., unit: date, format: "%m/%d/%Y %I:%M:%S %p"}, or date and time in two columns: {column: [DATE, TIME], unit: date}'


def seconds_of(text, form=None):
    """(seconds, has a zone) of a date and time of the day, None where it is none. Without a zone it is taken as UTC. `form`: as of strptime; without it
    ISO 8601, year first, with - or / between its parts."""
    try:
        when = datetime.strptime(text.strip(), form) if form else iso(text.strip())
        return None if when is None else ((when if when.tzinfo else when.replace(tzinfo=timezone.utc)).timestamp(), when.tzinfo is not None)
    except (ValueError, OverflowError):
        return None


def iso(text):
    parts = ISO.match(text)
    if parts is None:
        return None
    year, _, month, day, hour, minute, second, fraction, zone = parts.groups()
    when = datetime(int(year), int(month), int(day), int(hour), int(minute), int(second or 0), int(((fraction or "") + "000000")[:6]))
    return when if zone is None else when.replace(tzinfo=zone_of(zone))


def zone_of(text):
    if text.upper() in ("Z", "UTC"):
        return timezone.utc
    minutes = 60 * int(text[1:3]) + int(text[-2:])
    return timezone(timedelta(minutes=-minutes if text[0] == "-" else minutes))


def written(seconds):
    """ISO 8601 of seconds since 1970 UTC."""
    return (datetime(1970, 1, 1) + timedelta(seconds=round(seconds, 3))).isoformat() + "Z"
