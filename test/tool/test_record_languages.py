#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Records with names of columns in other languages and in encodings that are guessed, and with numbers beyond those of floating point. See test_record.py."""
import unittest
import warnings

import numpy
from drill_rig_sim.field.record import RecordError, read_record
from record_folder import Folder


class Languages(Folder):
    HEADS = {
        "Spanish": "Tiempo (s);Altura del bloque (m);Profundidad de la barrena (m);Carga en el gancho (kN);Torsión (kN.m);Rotaria (rpm);Caudal de entrada (L/min);Presión de bomba (bar)",
        "French": "Temps (s);Hauteur du moufle (m);Profondeur outil (m);Poids au crochet (kN);Couple (kN.m);Vitesse de rotation (tr/min);Débit entrée (L/min);Pression de refoulement (bar)",
        "Portuguese": "Tempo (s);Altura do bloco (m);Profundidade da broca (m);Carga no gancho (kN);Torque (kN.m);Rotação (rpm);Vazão de entrada (L/min);Pressão de bombeio (bar)",
        "Norwegian": "Tid (s);Blokkposisjon (m);Bitdybde (m);Kroklast (kN);Dreiemoment (kN.m);Rotasjon (rpm);Strømningsrate inn (L/min);Standrørstrykk (bar)",
        "German": "Zeit (s);Blockhöhe (m);Meißelteufe (m);Hakenlast (kN);Drehmoment (kN.m);Drehzahl (1/min);Spülungsrate (L/min);Pumpendruck (bar)",
        "Dutch": "Tijd (s);Blokhoogte (m);Beiteldiepte (m);Haaklast (kN);Koppel (kN.m);Toerental (rpm);Debiet (L/min);Standpijpdruk (bar)"}
    SIGNALS = {"block_height": 20.0, "bit_depth": 1000.0, "hook_load": 8e5, "torque": 9e3, "top_drive_speed": 10.47198, "flow": 1.0 / 30.0, "stand_pipe_pressure": 1.5e7}

    def test_names(self):
        for language, head in self.HEADS.items():
            with self.subTest(language):
                record = self.read(head + "\n" + "".join("%d;20;1000;800;9;100;2000;150\n" % k for k in range(4)))
                for signal, value in self.SIGNALS.items():
                    numpy.testing.assert_allclose(record.signals[signal], value, rtol=1e-6, err_msg=signal)
                self.assertEqual(language == "Dutch", any("Debiet (L/min) is read as the flow into the well" in line for line in record.remarks))

    def test_a_guess_of_the_encoding_is_a_choice(self):
        """Chinese names in GBK are taken for latin-1."""
        path = self.file("r.csv", "时间 (s);大钩负荷 (kN)\n0;800\n1;800\n", "gbk")
        with self.assertRaisesRegex(RecordError, "needed: a map, --columns, or the file in UTF-8 where letters are wrong here .it is not UTF-8 and was read as latin-1.$"):
            read_record(path)

    def test_numbers_near_the_largest(self):
        rows = ["%d,%s,20" % (k, "1.7e308" if k == 5 else "%.1f" % (800.0 + k % 3)) for k in range(40)]
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            record = self.read("Time (s),Hook Load (kN),Block (m)\n" + "\n".join(rows) + "\n")
        self.assertEqual([5], list(numpy.flatnonzero(numpy.isnan(record.signals["hook_load"]))))


if __name__ == "__main__":
    unittest.main()
