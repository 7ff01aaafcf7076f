# SPDX-License-Identifier: BSD-3-Clause
"""Dates with a time of the day as records write them, in seconds since 1970 UTC."""
import itertools
import re
from datetime import datetime, timedelta, timezone

from drill_rig_sim.field.signals import latin_letters

CLOCK = r"(?P<hour>\d\d?):(?P<minute>\d\d)(?::(?P<second>\d\d)(?:(?:[.,]|:(?=\d{3}\b))(?P<fraction>\d+))?)?"
OFFSET = r"[+-]\d\d?(?::?\d\d)?"
ZONE = r"Z|(?:UTC|GMT)(?: ?" + OFFSET + ")?|" + OFFSET
HALF = r"(?P<half>[AP]\.? ?M\.?(?![A-Z]))?"
REST = r"(?:[T ]+|, ?|_)" + CLOCK + r"\s*" + HALF + r"\s*(?:Uhr)?(?P<zone>" + ZONE + ")?$"
DAY_OF_WEEK = r"(?:(?:mon|tue|wed|thu|fri|sat|sun)[a-z]*\.?,? +)?"
# English, German, Dutch, Norwegian, French, Spanish, Portuguese and Italian, without accents; marraskuu of Finnish is November
MONTHS = ("jan ene gen", "feb fev", "mar mrt maa", "apr avr abr", "may mai mag mei maj", "jun juin giu", "jul juil lug", "aug aou ago", "sep set", "oct okt out ott", "nov", "dec dez dic des")
MONTH = r"(?P<month>(?:%s)(?!raskuu))[a-z]*\.?" % "|".join(name for names in MONTHS for name in names.split())
# in the name of a column or in its unit: `Time (UTC+2)`, `TIME_GMT`, `Time [+02:00]`, `Time (UTC + 5.5 h)`
HOURS = r"\s*(?:h|hrs?|hours?)"
OFFSET_IN_NAME = r"[+\-\u2212\u2013]\s*\d\d?(?::?\d\d|[.,]\d+)?(?:" + HOURS + ")?"
ZONE_IN_NAME = re.compile(r"(?<![A-Za-z])((?:UTC|GMT)(?:\s*" + OFFSET_IN_NAME + r")?)(?![A-Za-z\d])|[(\[<{]\s*(Z|(?:UTC|GMT)(?:\s*" + OFFSET_IN_NAME + r")?|" + OFFSET_IN_NAME +
                          r")\s*[)\]>}]", re.IGNORECASE)
# names of zones: the same one stands for several offsets (CST: Chicago, Shanghai), and summer time comes and goes
NAMES_OF_ZONES = ("ACDT ACST ADT AEDT AEST AKDT AKST ART AST AWST BRT BST CAT CDT CEST CET CST EAT EDT EEST EET EST GST HKT HST ICT IST JST KST MDT MSK MST NDT NST NZDT "
                  "NZST PDT PKT PST SGT WAT WEST WET WIB")
# of the zone database as well: America/Chicago
REGIONS = "Africa America Antarctica Arctic Asia Atlantic Australia Brazil Canada Chile Etc Europe Indian Mexico Pacific US"
NAME_OF_ZONE = re.compile(r"(?<![A-Za-z])([Ll]ocal|LOCAL|%s|(?:%s)/[A-Za-z_]+(?:/[A-Za-z_]+)?)(?![A-Za-z])" % ("|".join(NAMES_OF_ZONES.split()), "|".join(REGIONS.split())))
# whose order of day and month needs no guess: year first, months by name, points (day first), the day of the year
UNMISTAKABLE = [re.compile(form, re.IGNORECASE) for form in (
    r"(?P<year>\d{4})(?P<sign>[-/.])(?P<month>\d\d?)(?P=sign)(?P<day>\d\d?)" + REST,
    DAY_OF_WEEK + r"(?P<day>\d\d?)(?P<sign>[-/ ]|\. ?|)" + MONTH + r"(?P=sign)(?P<year>\d{4})" + REST,
    r"(?P<day>\d\d?)\. " + MONTH + r" (?P<year>\d{4})" + REST,
    r"(?P<day>\d\d?)\.(?P<month>\d\d?)\.(?P<year>\d{4})" + REST,
    DAY_OF_WEEK + MONTH + r" +(?P<day>\d\d?),? +(?P<year>\d{4})" + REST,
    DAY_OF_WEEK + MONTH + r" +(?P<day>\d\d?) +" + CLOCK + r"(?P<half>)(?: +(?P<zone>" + ZONE + r"))? +(?P<year>\d{4})$",  # of ctime
    r"(?P<year>\d{4})[-/. ](?P<day_of_year>\d{3})" + REST,
    r"(?P<year>\d{4}):(?P<day_of_year>\d{3}):" + CLOCK + r"(?P<half>)(?P<zone>Z)?$",
    # of ISO 8601 without signs: 20240521T095950Z, 20240521 095950, 2024142T095950
    r"(?P<year>(?:19|20)\d\d)(?:(?P<month>\d\d)(?P<day>\d\d)|(?P<day_of_year>\d{3}))[T _](?P<hour>\d\d)(?P<minute>\d\d)(?P<second>\d\d)(?:[.,](?P<fraction>\d+))?(?P<half>)"
    r"(?P<zone>" + ZONE + ")?$")]
ELAPSED = re.compile(r"(?:(\d+)\s*(?:d|days?)[,\s]*)?(\d+):([0-5]?\d):([0-5]?\d(?:[.,]\d+)?)$", re.IGNORECASE)
SPANISH_HALF = re.compile(r"\b([AP])\. ?M\.?(?![A-Z])", re.IGNORECASE)  # a. m.
TWO_PARTS = re.compile(r"(\d+):([0-5]\d(?:[.,]\d+)?)$")
OF_DAY = re.compile(CLOCK + r"\s*([AP]M)?$", re.IGNORECASE)
TOUCHING = re.compile(r"%[a-zA-Z]%[a-zA-Z]")
DAYS = ("%d/%m/%Y", "%m/%d/%Y", "%d-%m-%Y", "%m-%d-%Y", "%d/%m/%y", "%m/%d/%y", "%d.%m.%y", "%y.%m.%d", "%y/%m/%d", "%y-%m-%d", "%d-%m-%y", "%m-%d-%y", "%d-%b-%y", "%d %b %y", "%b %d %y", "%Y%m%d",
        "%d%m%Y", "%y%m%d", "%d.%m.%Y", "%Y-%m-%d", "%Y/%m/%d", "%j/%Y", "%y-%j", "%Y\u5e74%m\u6708%d\u65e5")
CLOCKS = ("%H:%M:%S", "%H:%M:%S.%f", "%I:%M:%S %p", "%H:%M", "%I:%M %p", "%I:%M:%S%p", "%H.%M.%S", "%H-%M-%S", "%Hh%Mm%Ss", "%Hh%Mm%S", "%H%M%S", "%H\u65f6%M\u5206%S\u79d2")
GUESSED = [" ".join(both) for both in itertools.product(DAYS, CLOCKS)] + [clock + " " + day for clock, day in itertools.product(CLOCKS[:5], DAYS)]
GUESSED += ["%Y-%m-%d-%H-%M-%S", "%Y-%m-%d-%H:%M:%S", "%Y-%m-%d_%H-%M-%S", "%Y%m%d%H%M%S", "%Y%m%d%H%M", "%y%m%d%H%M%S", "%d%m%Y%H%M%S", *CLOCKS[:3], "%j:%H:%M:%S", "%j %H:%M:%S"]
MOST_GUESSES = 3
LONGEST = 80  # signs of a date
MOST_OFFSET = 14 * 60  # of a time zone [min]
EARLIEST = -20 * 365.25 * 86400.0  # of a record, 1950 [s]; dates before it stand for none
# as databases write a day that has no time, and a time that has no day
MIDNIGHT = re.compile(r"[T ]+(?:0?0:00(?::00(?:\.0+)?)?|12:00(?::00)? ?AM)$", re.IGNORECASE)
NO_DAY = re.compile(r"(?:1899-12-3[01]|1900-01-0[01]|12/30/1899|30[./]12[./]1899|1970-01-01)[T ]+")
SPREADSHEET = (32874.0, 73051.0)  # days since 1899-12-30, of the years 1990 to 2099


FIELDS = {"yyyy": "%Y", "yy": "%y", "dd": "%d", "mmm": "%b", "mon": "%b", "hh": "%H", "ss": "%S", "t": "T"}  # as headers write them; mm is a month or a minute


def form_said(texts):
    """The format, as of strptime, of dates whose header writes DD/MM/YYYY HH:MM:SS, in one text or in two; None where it writes none."""
    form = " ".join(form_in(text) or "%H:%M:%S" * (k > 0) for k, text in enumerate(texts))
    return form if all(field in form.lower() for field in ("%y", "%d", "%h")) else None


def form_in(text):
    """Of one text, "" where it is none."""
    form = ""
    for part in re.findall(r"yyyy|yy|mmm|mon|mm|dd|hh|ss|t|[a-z]+|[^a-z]+", text.strip(" ()[]").lower()):
        if part == "mm":
            form += "%M" if "%H" in form else "%m"
        elif part in FIELDS or not part.isalpha() and set(part) <= set("-/.: "):
            form += FIELDS.get(part, part)
        else:
            return ""
    return form


def seconds_of(text, form=None):
    """(seconds, has a zone) of a date and time of the day, None where it is none. Without a zone it is taken as UTC. `form`: as of strptime; without it
    ISO 8601 and other forms whose order of day and month is sure."""
    text = text.strip()
    if len(text) > LONGEST:
        return None
    try:
        when = by_form(text, form) if form else unmistakable(text)
        return None if when is None else ((when if when.tzinfo else when.replace(tzinfo=timezone.utc)).timestamp(), when.tzinfo is not None)
    except (ValueError, OverflowError):
        return None


def own_offset(text, form=None):
    """Of the time zone in a date, ahead of UTC [s]; None without one. `form` as in seconds_of()."""
    try:
        when = by_form(text.strip(), form) if form else unmistakable(text.strip())
        return when.utcoffset().total_seconds() if when is not None and when.tzinfo else None
    except (ValueError, OverflowError):
        return None


def by_form(text, form):
    text = SPANISH_HALF.sub(r"\1m", text)
    when = datetime.strptime(text, form)
    if TOUCHING.search(form) and len(when.strftime(form)) > len(text) and "%f" not in form:
        return None  # 1005 by %H%M%S: strptime would take it for 10:00:05, it may be 00:10:05
    return when


def unmistakable(text):
    text = text if text.isascii() else latin_letters(text)
    found = next((match for match in (form.match(text) for form in UNMISTAKABLE) if match), None)
    if found is None:
        return None
    parts = found.groupdict()
    year, hour, minute, second = (int(parts[name] or 0) for name in ("year", "hour", "minute", "second"))
    if parts["half"]:
        if not 1 <= hour <= 12:
            return None
        hour = hour % 12 + 12 * (parts["half"][0].upper() == "P")
    day = datetime(year, month_of(parts["month"]), int(parts["day"])) if parts.get("month") else datetime(year, 1, 1) + timedelta(days=int(parts["day_of_year"]) - 1)
    if day.year != year or hour > 24 or minute > 59 or second > 60:  # 24:00:05 is of the next day, 23:59:60 the end of this one
        return None
    when = day + timedelta(hours=hour, minutes=minute, seconds=second, microseconds=int(((parts["fraction"] or "") + "000000")[:6]))
    return when if parts["zone"] is None else when.replace(tzinfo=zone_of(parts["zone"]))


def month_of(text):
    return int(text) if text.isdigit() else 1 + next(k for k, names in enumerate(MONTHS) if text.lower() in names.split())


def zone_of(text):
    """Of a text by ZONE. ValueError where there is no such zone."""
    text = re.sub(HOURS + "$", "", text, flags=re.IGNORECASE)
    sign, digits, share = re.search(r"([+\-\u2212\u2013]?)\s*([\d:]*)([.,]\d+)?$", text).groups()
    digits = digits.replace(":", "")
    hours, minutes = (digits[:-2], digits[-2:]) if len(digits) > 2 else (digits, "0")
    offset = 60 * int(hours or "0") + int(minutes) + 60 * float("0." + share[1:] if share else 0)
    if offset > MOST_OFFSET:
        raise ValueError("no time zone: " + text)
    return timezone(timedelta(minutes=-offset if sign and sign != "+" else offset))


def offset_of(text):
    """Of a text that is a time zone, ahead of UTC [s]; None where it is none, or has only a name."""
    try:
        return zone_of(text).utcoffset(None).total_seconds() if re.fullmatch(ZONE, text, re.IGNORECASE) else None
    except ValueError:
        return None


def zone_said(names):
    """(zone or None, its text) of what the names and units of columns say of it; a zone that has only a name is none, its text is that name. ("", None) without."""
    for name in names:
        found = ZONE_IN_NAME.search(name)
        if found:
            text = found[1] or found[2]
            try:
                return zone_of(text), text
            except ValueError:
                return None, text
        if NAME_OF_ZONE.search(name):
            return None, NAME_OF_ZONE.search(name)[1]
    return None, ""


def without_zone(name):
    """The name of a column without a time zone in it."""
    return ZONE_IN_NAME.sub("", name).strip(" _-/,") if ZONE_IN_NAME.search(name) else name


def elapsed_of(cells, header):
    """Seconds of cells such as 25:00:05 or `1 day 00:00:05`, nan where one is empty; None where they are no elapsed times: other texts, and times of the day, whose
    hours stay below 24 and whose header does not say that they are elapsed. `header`: names and unit of the column. Two numbers need mm:ss or hh:mm there."""
    word = re.sub("[^a-z]", "", header.lower())
    two = next((size for name, size in (("hhmmss", 0.0), ("mmss", 60.0), ("minsec", 60.0), ("hhmm", 3600.0)) if name in word), 0.0)
    found, sure = [], word.startswith("etim") or any(name in word for name in ("elapsed", "duration", "runtime"))
    for cell in cells:
        match = ELAPSED.match(cell) if cell else None
        parts = match or (TWO_PARTS.match(cell) if two and cell else None)
        if cell and parts is None:
            return None
        if not cell:
            found.append(float("nan"))
        elif match:
            days, hours, minutes, seconds = (float((part or "0").replace(",", ".")) for part in match.groups())
            sure = sure or hours >= 24 or match[1] is not None
            found.append(86400.0 * days + 3600.0 * hours + 60.0 * minutes + seconds)
        else:
            sure = sure or two == 60.0 or float(parts[1]) >= 24
            found.append(two * float(parts[1]) + two / 60.0 * float(parts[2].replace(",", ".")))
    return found if sure and any(cells) else None


def joined(cells):
    """The text of a date in one cell, or in two: a day and a time of the day."""
    if len(cells) == 2:
        cells = MIDNIGHT.sub("", cells[0]), NO_DAY.sub("", cells[1])
    return " ".join(cells).strip()


def is_time_of_day(text):
    return len(text) <= LONGEST and OF_DAY.match(text.strip()) is not None


def fitting(cells):
    """The formats of GUESSED that read all of these cells."""
    return [form for form in GUESSED if all(seconds_of(cell, form) for cell in cells)] if cells else []


def forms_for(cells, names):
    """What may be written of dates in the columns `names`, for a message; the formats that read all of these cells are named, and a zone that has only a name."""
    named = NAME_OF_ZONE.search(cells[0]) if cells else None
    if named and seconds_of(NAME_OF_ZONE.sub("", cells[0])):
        return "a time zone such as UTC-06:00, because %s is ambiguous" % named[1]
    found = fitting(cells)
    example = ' or '.join('"%s"' % form for form in found[:MOST_GUESSES]) or '"%m/%d/%Y %I:%M:%S %p" (codes of strptime)'
    own = "a format in a map: {column: %s, unit: date, format: %s}" % (names[0] if len(names) == 1 else "[%s]" % ", ".join(names), example)
    return own if found else "ISO 8601 such as 2017-07-31T23:59:00Z, or %s%s" % (
        own, ", or date and time in two columns: {column: [DATE, TIME], unit: date}" if len(names) == 1 else "")


def number_as_time(text, name):
    """(what a number without a unit may be as a time, a line of a map for it), for a message; None where it may be anything."""
    number = float(text)
    unit, what = next(((unit, "%s since 1970" % unit) for unit, count in (("s", 1.0), ("ms", 1e3), ("us", 1e6)) if 6.3e8 <= number / count < 4.1e9), (None, None))
    if SPREADSHEET[0] <= number < SPREADSHEET[1] and "." in text:
        unit, what = "d", "a spreadsheet's days since 1899-12-30"
    elif 0.0 < number < 1.0:
        unit, what = "d", "a share of a day"
    return (what, "{column: %s, unit: %s}" % (name, unit)) if unit else None


def written(seconds):
    """ISO 8601 of seconds since 1970 UTC."""
    return (datetime(1970, 1, 1) + timedelta(seconds=round(seconds, 3))).isoformat() + "Z"
