# SPDX-License-Identifier: BSD-3-Clause
"""Units that stand in the cells of a table, as in `12.5 klbf`: taken to where the file says the unit of a column."""
from drill_rig_sim.field.cells import is_blank, is_number
from drill_rig_sim.field.table import RecordError
from drill_rig_sim.field.units import QUANTITIES, is_unit, parts_of, same_unit

LOOKED_AT = 50  # filled cells of a column, among the first ones


def take_units(table):
    """Numbers alone in the cells of a table, the unit of each column beside its name. RecordError with the first cell whose unit is another one than that of the
    header or of the cells before it, and with the first without a unit where neither the header nor the map says one. Remarks: a line for each column."""
    for place in range(len(table.names)):
        filled = [row[place] for row in table.rows[:4 * LOOKED_AT] if not is_blank(row[place])][:LOOKED_AT]
        if any(parts_of(cell) for cell in filled):
            take_of(table, place)


def take_of(table, place):
    """Of one column."""
    said, bare, first = table.units[place], None, None
    for k, row in enumerate(table.rows):
        cell = row[place].strip()
        parts = parts_of(cell)
        if parts is None:
            bare = k if bare is None and is_number(cell) else bare
            continue
        row[place], unit = parts
        if said is not None and unit != said and not agree(unit, said):
            raise RecordError("%s: %s: %s is in another unit than %s; needed: one unit in a column" %
                              (table.place(k), table.names[place], cell, "the header says (%s)" % said if first is None else "the cells before (%s)" % said))
        said, first = unit if said is None else said, (k, cell) if first is None else first
    if table.units[place] is None and bare is not None:
        raise RecordError("%s: %s: %s has no unit, others of this column have one (%s: %s); needed: a unit in every cell, or in the header" %
                          (table.place(bare), table.names[place], table.rows[bare][place].strip(), table.place(first[0]), first[1]))
    table.units[place], table.unit_cells[place] = said, "%s: %s" % (table.place(first[0]), first[1])
    table.remarks.append("%s: its cells hold their unit (first: %s)" % (table.names[place], table.unit_cells[place]))


def agree(unit, said):
    """Whether two units are the same, or the header's is not known as one."""
    return not is_unit(said) or (any(is_unit(unit, quantity) and is_unit(said, quantity) for quantity in QUANTITIES) and same_unit(unit, said))
