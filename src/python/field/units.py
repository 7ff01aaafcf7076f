"""Units of records, to SI: the symbols of the WITSML unit dictionary and the spellings that rigs use."""
import math
import re

# exact by definition: international foot and pound, standard gravity, US and imperial gallon, oil barrel of 42 US gallons
FOOT, POUND, INCH = 0.3048, 4.4482216152605, 0.0254                # [m], [N], [m]
GALLON, IMPERIAL, BARREL = 3.785411784e-3, 4.54609e-3, 0.158987294928  # [m3]
KILOGRAM = 9.80665                                                   # its weight [N]
PSI = POUND / INCH**2                                                # [Pa]
TURN = 2.0 * math.pi                                                 # [rad]
MINUTE, HOUR, DAY = 60.0, 3600.0, 86400.0                            # [s]

LENGTH = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "km": 1e3, "ft": FOOT, "ftUS": 1200.0 / 3937.0, "in": INCH, "yd": 3.0 * FOOT}
SPEED = {"m/s": 1.0, "cm/s": 1e-2, "mm/s": 1e-3, "m/min": 1.0 / MINUTE, "m/h": 1.0 / HOUR, "km/h": 1e3 / HOUR,
         "m/d": 1.0 / DAY,
         "ft/s": FOOT, "ft/min": FOOT / MINUTE, "ft/h": FOOT / HOUR, "ft/d": FOOT / DAY, "kft/h": 1e3 * FOOT / HOUR, "in/s": INCH, "in/min": INCH / MINUTE}
FORCE = {"N": 1.0, "daN": 10.0, "kN": 1e3, "kdaN": 1e4, "10 kN": 1e4, "MN": 1e6, "mN": 1e-3, "dyne": 1e-5, "kdyne": 1e-2, "ozf": POUND / 16.0, "lbf": POUND, "klbf": 1e3 * POUND,
         "gf": 1e-3 * KILOGRAM, "kgf": KILOGRAM, "kkgf": 1e3 * KILOGRAM, "1000 kgf": 1e3 * KILOGRAM, "Mgf": 1e3 * KILOGRAM, "mgf": 1e-6 * KILOGRAM,
         "tonfUS": 2000.0 * POUND, "tonfUK": 2240.0 * POUND}
TORQUE = {"N.m": 1.0, "daN.m": 10.0, "kN.m": 1e3, "kdaN.m": 1e4, "MN.m": 1e6, "mN.m": 1e-3, "dN.m": 0.1, "ft.lbf": FOOT * POUND, "kft.lbf": 1e3 * FOOT * POUND,
          "1000 ft.lbf": 1e3 * FOOT * POUND, "in.lbf": INCH * POUND, "kgf.m": KILOGRAM, "kkgf.m": 1e3 * KILOGRAM, "tonfUS.ft": 2000.0 * POUND * FOOT}
PRESSURE = {"Pa": 1.0, "hPa": 100.0, "kPa": 1e3, "MPa": 1e6, "mPa": 1e-3, "mbar": 100.0, "bar": 1e5, "psi": PSI, "kpsi": 1e3 * PSI, "hbar": 1e7, "atm": 101325.0,
            "at": KILOGRAM * 1e4, "kgf/cm2": KILOGRAM * 1e4, "kgf/m2": KILOGRAM, "kgf/mm2": KILOGRAM * 1e6,
            "N/m2": 1.0, "kN/m2": 1e3, "N/mm2": 1e6, "lbf/ft2": POUND / FOOT**2, "psf": POUND / FOOT**2}
TURNING = {"rad/s": 1.0, "rpm": TURN / MINUTE, "rev/min": TURN / MINUTE, "c/min": TURN / MINUTE, "rev/s": TURN, "c/s": TURN, "Hz": TURN,
           "rev/h": TURN / HOUR, "c/h": TURN / HOUR, "deg/s": TURN / 360.0, "dega/s": TURN / 360.0, "deg/min": TURN / 360.0 / MINUTE,
           "dega/min": TURN / 360.0 / MINUTE, "dega/h": TURN / 360.0 / HOUR}
FLOW = {"m3/s": 1.0, "m3/min": 1.0 / MINUTE, "m3/h": 1.0 / HOUR, "m3/d": 1.0 / DAY, "L/s": 1e-3, "L/min": 1e-3 / MINUTE, "L/h": 1e-3 / HOUR, "dm3/s": 1e-3, "cm3/s": 1e-6, "cm3/min": 1e-6 / MINUTE,
        "galUS/s": GALLON, "galUS/min": GALLON / MINUTE, "gpm": GALLON / MINUTE, "galUS/h": GALLON / HOUR, "galUS/d": GALLON / DAY,
        "galUK/min": IMPERIAL / MINUTE, "galUK/h": IMPERIAL / HOUR, "bbl/min": BARREL / MINUTE, "bbl/h": BARREL / HOUR, "bbl/d": BARREL / DAY, "kbbl/d": 1e3 * BARREL / DAY,
        "ft3/s": FOOT**3, "ft3/min": FOOT**3 / MINUTE, "ft3/h": FOOT**3 / HOUR}
DATE = "date"  # the cells are dates with a time of the day, not numbers
TIME = {"s": 1.0, "ms": 1e-3, "us": 1e-6, "min": MINUTE, "h": HOUR, "d": DAY, DATE: None}

# usual spellings of a symbol; case and the signs between the parts do not matter (see plain())
SPELLINGS = {
    "length": {"m": "metre metres meter meters mtr mtrs mts mrt", "ft": "feet foot f '", "in": "inch inches"},
    "speed": {"ft/h": "ft/hr fph feet/hr feet/hour", "m/h": "m/hr mph mtr/hr", "ft/min": "fpm feet/min", "m/min": "mpm mtr/min", "ft/s": "fps ft/sec", "m/s": "m/sec"},
    "force": {"klbf": "klb klbs klbsf klbm klb.f kip kips k.lb k.lbs k.lbf kpound kpounds kilopounds 1000.lbf 1000.lb 1000.lbs 1000lbf 1000lb 1000lbs", "lbf": "lb lbs lbsf lb.f pound pounds pounds.force poundforce", "kN": "kilonewton kilonewtons k.n",
              "kdaN": "1000.dan", "1000 kgf": "t te tonnef tonne.f ton(metric) metricton metrictons tonne tonnes metric.ton metric.tons tonf.metric tonfm 1000kgf kkgf 1000.kg 1000kg", "kgf": "kg",
              "tonfUS": "ustonf ton(us) tons(us) ston stons short.ton short.tons us.ton us.tons", "tonfUK": "uktonf ton(uk) tons(uk) long.ton long.tons"},
    "torque": {"kft.lbf": "kft.lb kft.lbs klbf.ft klb.ft klbs.ft kftlb kftlbs kftlbf 1000.ft.lb 1000.ft.lbs 1000.lbf.ft ft.klbf ft.klb ft.klbs ft.kip ft.kips kip.ft kips.ft k.lb.ft k.lbs.ft k.lbf.ft k.ft.lb k.ft.lbf k.ft.lbs klbft",
               "ft.lbf": "ft.lb ft.lbs lbf.ft lb.ft lbs.ft ftlb ftlbs ftlbf lbft foot.pound foot.pounds", "N.m": "nm", "kN.m": "knm", "daN.m": "danm", "kdaN.m": "kdanm",
               "in.lbf": "in.lb in.lbs lbf.in lb.in", "kgf.m": "kg.m kgm m.kgf"},
    "pressure": {"psi": "psig psi(g) lbf/in2 lb/in2 lbs/in2", "bar": "bars barg bar(g)", "kpsi": "ksi", "kgf/cm2": "kg/cm2 kgcm2 ksc"},
    "turning": {"rpm": "r/min 1/min revs/min /min min.1 rev.min.1 r.p.m rpms", "rad/s": "rad/sec", "rev/s": "rps"},
    "flow": {"gpm": "galus/minute usgpm gal(us)/min usgal/min us.gal/min us.gpm gpm(us) usg/min", "galUK/min": "igpm gal(uk)/min ukgal/min uk.gal/min impgal/min", "L/min": "lpm ltr/min liter/min litre/min l/minute liters/min litres/min dm3/min lt/min", "L/s": "lps l/sec ltr/s", "m3/min": "m3pm kl/min 1000.l/min",
             "m3/h": "m3/hr", "bbl/min": "bpm bbls/min stb/min", "bbl/h": "bbl/hr bph", "ft3/min": "cfm cu.ft/min"},
    "time": {"s": "sec secs second seconds second(s)", "min": "mins minute minutes minute(s)", "h": "hr hrs hour hours hour(s)", "d": "day days", DATE: "datetime iso.8601 date.time",
             "ms": "msec millisecond milliseconds", "us": "usec"},
}
# the same letters for several units: refused, with what may be meant
AMBIGUOUS = {
    "force": {name: "tonfUS (2000 lbf), tonfUK (2240 lbf) or 1000 kgf" for name in ("ton", "tons", "tonf", "tonsf", "tf", "kton", "mt")} |
             {name: "klbf (1000 lbf); M is a thousand in some files, a million in others" for name in ("mlbf", "mlb", "mlbs")},
    "torque": {name: "tonfUS.ft" for name in ("ton.ft", "tonf.ft", "ft.ton", "ft.tonf")},
}
US_BY_CUSTOM = {"flow": {"gal/min": "galUS/min", "gal/h": "galUS/h", "gals/min": "galUS/min", "gal/hr": "galUS/h"}}  # as oilfield logs write them

TABLES = {"length": LENGTH, "speed": SPEED, "force": FORCE, "torque": TORQUE, "pressure": PRESSURE, "turning": TURNING, "flow": FLOW, "time": TIME}


class UnitError(Exception):
    """Why a text is not the unit of a quantity, and what is allowed."""


def plain(text):
    """A unit's spelling without case and without the kind of sign between its parts: `kft_lb`, `kft-lb` and `kft*lb` become `kft.lb`."""
    text = text.strip().lower().replace("³", "3").replace("²", "2").replace("^", "").replace("**", "")
    text = re.sub(r"[\s_.]+per[\s_.]+", "/", text)
    text = re.sub(r"[\s_\-·⋅*.]+", ".", text)
    return re.sub(r"\.?/\.?", "/", text).strip(".")


def spellings(quantity):
    """Plain spelling -> the symbols that it may stand for."""
    found = {}
    for symbol in TABLES[quantity]:
        found.setdefault(plain(symbol), set()).add(symbol)
    for symbol, words in SPELLINGS.get(quantity, {}).items():
        for word in words.split():
            found.setdefault(word, set()).add(symbol)
    for word, symbol in US_BY_CUSTOM.get(quantity, {}).items():
        found.setdefault(word, set()).add(symbol)
    return found


PLAIN = {quantity: spellings(quantity) for quantity in TABLES}


def factor_of(quantity, text):
    """SI units in one of `text`, None for dates. UnitError where it is no unit of the quantity, or may be several."""
    table, exact = TABLES[quantity], text.strip()
    if exact in table:
        return table[exact]
    word = plain(text)
    if word in AMBIGUOUS.get(quantity, {}):
        raise UnitError("unit %s is ambiguous; allowed: %s" % (exact, AMBIGUOUS[quantity][word]))
    symbols = PLAIN[quantity].get(word, set())
    if len({table[symbol] for symbol in symbols}) > 1:
        raise UnitError("unit %s is ambiguous; allowed: %s" % (exact, " or ".join(sorted(symbols))))
    if not symbols:
        raise UnitError("unit %s is not known for a %s; allowed: %s" % (exact or "(none)", NOUNS[quantity], ", ".join(table)))
    return table[next(iter(symbols))]


def same_unit(one, other):
    """Whether two texts may be the same unit; of units that are not known, yes."""
    for quantity in TABLES:
        try:
            factors = factor_of(quantity, one), factor_of(quantity, other)
        except UnitError:
            continue
        return None in factors or factors[0] == factors[1]
    return True


NOUNS = {"length": "length", "speed": "speed", "force": "force", "torque": "torque", "pressure": "pressure", "turning": "rotary speed", "flow": "flow rate", "time": "time"}
