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
    "time": "TIME DATETIME DATE_TIME TIMESTAMP RIGTIME DATE-TIME TIM TIME_STAMP RIG_TIME ETIM ETIME ELAPSED_TIME ELAPSED ZEITSTEMPEL DATUM_ZEIT DATUM_UHRZEIT ZEIT "
            "UHRZEIT FECHA_HORA FECHA_Y_HORA HORA DATE_HEURE HEURE HORODATAGE DATA_HORA DATUM_TIJD DATO_TID DATA_VREMYA VREMYA DATA_ORA",
    "block_height": "BLOCKCOMP BPOS BLOCK_POSITION BLOCK_HEIGHT BLOCKHEIGHT BLKPOS BLOCKPOS TRAVELLING_BLOCK_POSITION TRAVELING_BLOCK_POSITION HOOK_HEIGHT HKHT BLOCK "
                    "BLOCK_POS BLK_POS BLOCK_HT TRAVELLING_BLOCK TRAVELING_BLOCK HOOK_POSITION BLKHT BLK_HGT BLOCK_HGT TRAV_BLOCK TOP_DRIVE_POSITION TOP_DRIVE_HEIGHT "
                    "TRAVELLING_BLOCK_HEIGHT TRAVELING_BLOCK_HEIGHT HAKENHOEHE HAKENHOHE BLOCKHOEHE BLOCKHOHE HAUTEUR_CROCHET HAUTEUR_DU_CROCHET POSITION_CROCHET "
                    "POSICION_BLOQUE POSICION_DEL_BLOQUE ALTURA_DEL_BLOQUE POSICAO_DO_BLOCO ALTURA_DO_BLOCO BLOKKPOSISJON BLOKKHOYDE POLOZHENIE_TALBLOKA "
                    "POLOZHENIE_TALEVOGO_BLOKA VYSOTA_TALBLOKA POLOZHENIE_KRYUKA VYSOTA_KRYUKA 0112",
    "top_drive_speed": "SURF_RPM RPMA RPM ROTARY_RPM ROTARY_SPEED TOP_DRIVE_RPM TOP_DRIVE_SPEED TDRPM TD_RPM SURFACE_RPM AVERAGE_ROTARY_SPEED RPM_SURFACE AVERAGE_RPM RPM_AVG "
                       "TOPDRIVE_RPM ROTARY TD_SPEED TDS_RPM TDS_SPEED ROTOR_RPM AVG_RPM AVERAGE_SURFACE_RPM AVG_SURFACE_RPM ROTARY_TABLE_RPM TABLE_RPM RTRPM RPM_SURFACE_AVG DREHZAHL "
                       "DREHTISCHDREHZAHL VITESSE_DE_ROTATION VITESSE_ROTATION VELOCIDAD_DE_ROTACION RPM_SUPERFICIE VELOCIDADE_DE_ROTACAO OBOROTY_ROTORA OBOROTY_VSP "
                       "CHASTOTA_VRASHCHENIYA SKOROST_VRASHCHENIYA 0120",
    "flow": "FLOWIN MFIA TFLO FLOW_IN FLOW_RATE_IN MUD_FLOW_IN TOTAL_PUMP_OUTPUT FLOW_PUMPS FLOW_RATE PUMP_OUTPUT FLOW_IN_RATE MFI PUMP_FLOW FLOWRATE MUD_FLOW "
            "MUD_FLOW_RATE FLOW PUMP_RATE PUMP_FLOW_RATE TOTAL_FLOW_IN CIRCULATION_RATE FLWIN FLIN QIN AVERAGE_FLOW_IN AVG_FLOW_IN FLOW_IN_AVG FLOW_IN_PUMPS SPUELRATE SPULRATE "
            "PUMPRATE DEBIT_ENTREE DEBIT_D_ENTREE DEBIT_INJECTION DEBIT_POMPES CAUDAL_ENTRADA CAUDAL_DE_ENTRADA VAZAO_ENTRADA VAZAO_DE_ENTRADA RASKHOD_NA_VKHODE "
            "RASKHOD_VKHOD PODACHA_NASOSOV 0130",
    "hook_load": "HKLD HKLA HOOKLOAD HOOK_LOAD HKL HL HKLD_AVG AVERAGE_HOOKLOAD HOOKLOAD_AVG AVERAGE_HOOK_LOAD HOOK_LOAD_AVG HKLDAV HKLAV HKL_AVG AVG_HOOK_LOAD "
                 "AVG_HOOKLOAD HOOK_LOAD_AVERAGE HKLOAD HOOKLD HOOK_LD WEIGHT_ON_HOOK HOOK_WEIGHT WOH HAKENLAST CHARGE_AU_CROCHET POIDS_AU_CROCHET CHARGE_CROCHET "
                 "POIDS_CROCHET CARGA_EN_EL_GANCHO CARGA_EN_GANCHO CARGA_AL_GANCHO CARGA_GANCHO PESO_EN_EL_GANCHO PESO_AL_GANCHO PESO_GANCHO CARGA_NO_GANCHO "
                 "PESO_NO_GANCHO KROKLAST VES_NA_KRYUKE NAGRUZKA_NA_KRYUKE 0114",
    "torque": "TORQUE TQA TOR SURFACE_TORQUE ROTARY_TORQUE TOP_DRIVE_TORQUE CONVERTIBLE_TORQUE STOR TQ TD_TORQUE TORQUE_AVG AVERAGE_SURFACE_TORQUE AVERAGE_TORQUE TRQ "
              "ROT_TORQUE SURF_TORQUE TDS_TORQUE TDTORQUE TDTRQ AVG_TORQUE TOR_AVG TQ_AVG ROTTORQ TORQUE_ABS TORQUE_ABS_AVG DREHMOMENT COUPLE COUPLE_ROTATION TORQUE_DE_SUPERFICIE "
              "TORQUE_SUPERFICIE DREIEMOMENT KRUTYASHCHIY_MOMENT MOMENT_NA_ROTORE 0118",
    "stand_pipe_pressure": "SPP SPPA STANDPIPE_PRESSURE STAND_PIPE_PRESSURE PUMP_PRESSURE SPP_AVG STANDPIPE_PRESSURE_AVG AVERAGE_STANDPIPE_PRESSURE STANDPIPE_PRESS "
                           "STAND_PIPE_PRESS PUMP_PRESS STANDPIPE MUD_PUMP_PRESSURE AVERAGE_SPP AVG_SPP PUMP_PRESSURE_AVG AVERAGE_PUMP_PRESSURE CIRCULATING_PRESSURE "
                           "STANDROHRDRUCK STEIGLEITUNGSDRUCK PUMPENDRUCK PRESSION_STANDPIPE PRESSION_DE_REFOULEMENT PRESSION_REFOULEMENT PRESSION_POMPES PRESSION_INJECTION "
                           "SPP_1 SPPA_1 STANDPIPE_PRESSURE_1 STAND_PIPE_PRESSURE_1 "
                           "PRESION_BOMBA PRESION_DE_BOMBA PRESION_DE_BOMBAS PRESION_STANDPIPE PRESSAO_BOMBA PRESSAO_DE_BOMBEIO PRESSAO_STANDPIPE PUMPETRYKK DAVLENIE_NA_STOYAKE "
                           "DAVLENIE_V_STOYAKE DAVLENIE_V_MANIFOLDE DAVLENIE_NAGNETANIYA 0121",
    "bit_depth": "BITDEP DBTM BIT_DEPTH BITDEPTH BIT_MD BIT_DEPTH_MD DEPTH_BIT MEASURED_BIT_DEPTH BIT_POSITION BIT_MEASURED_DEPTH BIT_DPTH BDEP DBIT MEISSELTEUFE "
                 "MEISSELTIEFE PROFONDEUR_OUTIL PROFONDEUR_DE_L_OUTIL COTE_OUTIL PROFUNDIDAD_BARRENA PROFUNDIDAD_DE_LA_BARRENA PROFUNDIDAD_BROCA PROFUNDIDADE_BROCA "
                 "PROFUNDIDADE_DA_BROCA GLUBINA_DOLOTA POLOZHENIE_DOLOTA 0108",
    "hole_depth": "DMEA HOLE_DEPTH HOLEDEPTH HOLE_MD TOTAL_DEPTH DEPTH_HOLE HOLE_DEPTH_MD HOLE_MEASURED_DEPTH HOLE_DPTH HDEP TDEP BOHRTEUFE BOHRLOCHTEUFE PROFONDEUR_TROU "
                  "PROFONDEUR_DU_TROU COTE_FOND PROFUNDIDAD_POZO PROFUNDIDAD_DEL_POZO PROFUNDIDADE_DO_POCO HULLDYBDE GLUBINA_ZABOYA ZABOY GLUBINA_SKVAZHINY 0110",
}
# of a time series of drill run --csv --readings
OWN = {"time": "time", "block_height": "reading_block_height", "top_drive_speed": "top_drive_speed", "flow": "reading_flow", "hook_load": "reading_hook_load",
       "torque": "reading_torque", "stand_pipe_pressure": "reading_stand_pipe_pressure", "bit_depth": "reading_bit_depth", "hole_depth": "reading_hole_depth"}


def word(name):
    """In small Latin letters, without signs and accents."""
    return re.sub(r"[^a-z0-9]", "", (name if name.isascii() else latin_letters(name)).lower())


def words_in(name):
    """The words of a name in small Latin letters."""
    return set(re.findall("[a-z]+", (name if name.isascii() else latin_letters(name)).lower()))


def latin_letters(text):
    """By math/latin_letters.h; as it stands where the Python module sim is not built."""
    try:
        from drill_rig_sim import _sim  # pylint: disable=import-outside-toplevel
    except ImportError:
        return text
    return _sim.latin_letters(text)


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
