"""Units as records have them, to SI: factor of each, by the quantity that a signal is."""
import math

FOOT, POUND, INCH, GALLON = 0.3048, 4.4482216152605, 0.0254, 3.785411784e-3  # [m], [N], [m], [m3]
KILOGRAM = 9.80665  # its weight [N]
PSI = POUND / INCH**2

LENGTH = {"m": 1.0, "ft": FOOT}
SPEED = {"m/s": 1.0, "m/min": 1.0 / 60.0, "m/h": 1.0 / 3600.0, "ft/s": FOOT, "ft/min": FOOT / 60.0, "ft/h": FOOT / 3600.0}
FORCE = {"N": 1.0, "kN": 1e3, "kdaN": 1e4, "10 kN": 1e4, "lbf": POUND, "klbf": 1e3 * POUND, "klb": 1e3 * POUND, "kgf": KILOGRAM, "tonf": 1e3 * KILOGRAM, "1000 kgf": 1e3 * KILOGRAM}
TORQUE = {"N.m": 1.0, "kN.m": 1e3, "ft.lbf": FOOT * POUND, "kft.lbf": 1e3 * FOOT * POUND, "1000 ft.lbf": 1e3 * FOOT * POUND}
PRESSURE = {"Pa": 1.0, "kPa": 1e3, "MPa": 1e6, "bar": 1e5, "psi": PSI}
TURNING = {"rad/s": 1.0, "rpm": math.pi / 30.0, "c/min": math.pi / 30.0}
FLOW = {"m3/s": 1.0, "m3/h": 1.0 / 3600.0, "L/min": 1e-3 / 60.0, "L/s": 1e-3, "galUS/min": GALLON / 60.0, "gpm": GALLON / 60.0}
TIME = {"s": 1.0, "min": 60.0, "h": 3600.0, "ms": 1e-3, "date": None}  # date: ISO 8601

# of the signals that a record may hold
QUANTITIES = {"time": TIME, "block_height": LENGTH, "block_velocity": SPEED, "top_drive_speed": TURNING, "flow": FLOW, "hook_load": FORCE, "torque": TORQUE,
              "stand_pipe_pressure": PRESSURE, "bit_depth": LENGTH, "hole_depth": LENGTH}
