# SPDX-License-Identifier: BSD-3-Clause
"""What a record may hold: each signal's quantity, its plausible range and the names that the trade gives it."""
import re

# of a signal: quantity, least and largest value that a rig's gauge can mean [SI]; what lies outside is no measurement
SIGNALS = {
    "time": ("time", None, None),
    "block_height": ("length", -20.0, 100.0),
    "block_velocity": ("speed", -20.0, 20.0),
    "top_drive_speed": ("angular speed", -50.0, 50.0),      # +-480 rpm
    "flow": ("flow", -0.02, 0.3),                      # up to 4750 gpm
    "hook_load": ("force", -5e5, 2e7),
    "torque": ("torque", -3e5, 3e5),
    "stand_pipe_pressure": ("pressure", -2e6, 2e8),
    "bit_depth": ("length", -100.0, 20000.0),
    "hole_depth": ("length", -100.0, 20000.0),
}
SI_UNITS = {"time": "s", "length": "m", "speed": "m/s", "angular speed": "rad/s", "flow": "m3/s", "force": "N", "torque": "N.m", "pressure": "Pa"}
# names of curves and columns, the first of a file's in this order is taken: WITSML and service companies, WITS by mnemonic, Pason, as words, WITS by item
NAMES = {
    "time": "TIME DATETIME DATE_TIME TIMESTAMP RIGTIME DATE-TIME TIM TIME_STAMP RIG_TIME ETIM ETIME ELAPSED_TIME ELAPSED ZEITSTEMPEL DATUM_ZEIT DATUM_UHRZEIT ZEIT UHRZEIT FECHA_HORA FECHA_Y_HORA HORA DATE_HEURE HEURE HORODATAGE DATA_HORA",
    "block_height": "BLOCKCOMP BPOS BLOCK_POSITION BLOCK_HEIGHT BLOCKHEIGHT BLKPOS BLOCKPOS TRAVELLING_BLOCK_POSITION TRAVELING_BLOCK_POSITION HOOK_HEIGHT HKHT BLOCK BLOCK_POS BLK_POS BLOCK_HT TRAVELLING_BLOCK TRAVELING_BLOCK HOOK_POSITION 0112",
    "top_drive_speed": "SURF_RPM RPMA RPM ROTARY_RPM ROTARY_SPEED TOP_DRIVE_RPM TOP_DRIVE_SPEED TDRPM TD_RPM SURFACE_RPM AVERAGE_ROTARY_SPEED RPM_SURFACE AVERAGE_RPM RPM_AVG TOPDRIVE_RPM ROTARY 0120",
    "flow": "FLOWIN MFIA TFLO FLOW_IN FLOW_RATE_IN MUD_FLOW_IN TOTAL_PUMP_OUTPUT FLOW_PUMPS FLOW_RATE PUMP_OUTPUT FLOW_IN_RATE MFI PUMP_FLOW FLOWRATE MUD_FLOW MUD_FLOW_RATE FLOW 0130",
    "hook_load": "HKLD HKLA HOOKLOAD HOOK_LOAD HKL HL HKLD_AVG AVERAGE_HOOKLOAD HOOKLOAD_AVG AVERAGE_HOOK_LOAD HOOK_LOAD_AVG HKLDAV HKLAV 0114",
    "torque": "TORQUE TQA TOR SURFACE_TORQUE ROTARY_TORQUE TOP_DRIVE_TORQUE CONVERTIBLE_TORQUE STOR TQ TD_TORQUE TORQUE_AVG AVERAGE_SURFACE_TORQUE AVERAGE_TORQUE TRQ ROT_TORQUE SURF_TORQUE 0118",
    "stand_pipe_pressure": "SPP SPPA STANDPIPE_PRESSURE STAND_PIPE_PRESSURE PUMP_PRESSURE SPP_AVG STANDPIPE_PRESSURE_AVG AVERAGE_STANDPIPE_PRESSURE STANDPIPE_PRESS STAND_PIPE_PRESS PUMP_PRESS STANDPIPE 0121",
    "bit_depth": "BITDEP DBTM BIT_DEPTH BITDEPTH BIT_MD BIT_DEPTH_MD DEPTH_BIT MEASURED_BIT_DEPTH 0108",
    "hole_depth": "DMEA HOLE_DEPTH HOLEDEPTH HOLE_MD TOTAL_DEPTH DEPTH_HOLE HOLE_DEPTH_MD 0110",
}
# of a time series of drill run --csv --readings
OWN = {"time": "time", "block_height": "reading_block_height", "top_drive_speed": "top_drive_speed", "flow": "reading_flow", "hook_load": "reading_hook_load",
       "torque": "reading_torque", "stand_pipe_pressure": "reading_stand_pipe_pressure", "bit_depth": "reading_bit_depth", "hole_depth": "reading_hole_depth"}


def word(name):
    """Without case and signs."""
    return re.sub(r"[^a-z0-9]", "", name.lower())


RANKS = {signal: {word(name): rank for rank, name in reversed(list(enumerate(names.split())))} for signal, names in NAMES.items()}


def known(names):
    """Signal -> places of the columns with one of its names, the best first."""
    found = {}
    for signal, ranks in RANKS.items():
        places = [place for place, name in enumerate(names) if word(name) in ranks]
        if places:
            found[signal] = sorted(places, key=lambda place: ranks[word(names[place])])
    return found


def si_unit(signal):
    return SI_UNITS[SIGNALS[signal][0]]
