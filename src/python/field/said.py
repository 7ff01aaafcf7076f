# SPDX-License-Identifier: BSD-3-Clause
"""What a file says of its own values: that they were simulated or forecast, not measured (`Data Type: Simulated`)."""
import re

NOT_MEASURED = set("simulated simulation simulations simulator synthetic artificial model models modelled modeled modelling modeling forecast forecasted forecasts predicted prediction predictions "
                   "prognosis prognosed theoretical calculated computed plan planned planning generated fictitious virtual estimated".split())
FILLERS = set("data dataset values value output outputs outcome record records log logs run results result file this is are a an the only not measured well rig drilling type of "
              "for purposes testing test from time real no s".split())
OUTRIGHT = set("simulated simulation synthetic forecast forecasted predicted modelled modeled theoretical artificial".split())  # whatever follows
KEY = re.compile(r"\W*((?:data|record|log|file|values?|curves?|channels?|measurement|run|job)s?\W*(?:type|source|kind|origin|class|category|mode|status|state|nature)?|type|(?:type|kind|source|origin|nature) of (?:the )?"
                 r"(?:data|values|record|log)|source|origin|kind|mode|status|state|purpose)\s*[\"']?\s*[:=,;|\t.]+\s*[\"']?(.*)", re.IGNORECASE)
PARTS = re.compile(r"[,;|\t]+")
SIGNS = " \t,;|#*\"'!%~-"
LONGEST = 200  # letters of a line that is looked at


def not_measured(text):
    """What a line says of the values, "" where it says nothing: a pair such as `Data Type: Simulated` in it, or a title such as `SYNTHETIC DATA`."""
    text = text[:LONGEST].strip(SIGNS)
    parts = [part for part in PARTS.split(text) if part.strip()]
    pairs = [text, *parts] if len(parts) > 1 else [text]
    found = next((pair for pair in pairs if is_pair(pair)), "")
    return found.strip(SIGNS) or (text if len(parts) == 1 and not set(":=") & set(text) and is_such(text) else "")


def is_pair(text):
    pair = KEY.match(text)
    value = PARTS.split(pair[2])[0].partition(":")[0] if pair else ""
    return is_such(value) or (re.findall("[a-z]+", value.lower()) or [""])[0] in OUTRIGHT


def is_such(text):
    """Whether a text says only that values are simulated or forecast."""
    words = re.findall("[a-z]+", text.lower())
    if NOT_MEASURED.intersection(words) == {"generated"} and re.search(r"\d", text):  # when a report was made
        return False
    return any(word in NOT_MEASURED for word in words) and all(word in NOT_MEASURED or word in FILLERS for word in words)


def remark_of(lines):
    """A line on the first of (line number, text) that speaks of such values; none else."""
    for number, text in lines:
        said = not_measured(text)
        if said:
            return ["line %d says that its values are not measured: %s" % (number, said)]
    return []
