// SPDX-License-Identifier: BSD-3-Clause
// The list of the laws of torque on bit: one row a law. It has no include guard: it is included once for each thing that is made
// from it.
//
//   BIT_LAW(name, limit, drag, by_cut, meaning)
//
// name     enumerator of BitTorqueModel, word of the scene file
// limit    function of contact/bit_torque.cpp that gives the largest torque
// drag     a drag bit: cutters and wear flats carry the weight by their width; it has `cutting_energy`, `wear_friction` and
// `wear_weight`.
//          Otherwise the face rubs, with `static`, `kinetic` and `speed_rpm`
// by_cut   weight and torque follow from the depth that each of its `blades` cuts (contact/bit_cut.h), not from the contact with
// the bottom.
//          It needs rock with exponents of 1, and does not ream
// meaning  one line, as the reference of the scene file shows it
//
// Made from it: BitTorqueModel and bit_laws (contact/bit_torque.h), the limits (contact/bit_torque.cpp), words and keys of the
// scene file. A new law goes to the end.
#ifndef BIT_LAW
#define BIT_LAW(...)
#endif

BIT_LAW(stribeck, limit_of_face, false, false, "mu(speed) weight diameter / 3, mu falls from static to kinetic")
BIT_LAW(detournay, detournay_bit_torque, true, false, "cutting and wear-flat friction")
BIT_LAW(regenerative, detournay_bit_torque, true, true,
        "cutting and friction where weight and torque follow from the depth of cut of each blade below the blade before it; "
        "without `bottom` "
        "and without friction across the face")

#undef BIT_LAW
