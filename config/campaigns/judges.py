"""What the campaigns beside this ask of a run; each gets a drill_rig_sim.campaign.played.Played."""
import numpy

WEIGHT = 60e3      # that the autodriller is asked for [N]
FRACTURE = 1350.0  # mud weight that opens the rock at the bit [kg/m3]


def means(values, t, seconds):
    """Running means over windows of these lengths [s]."""
    count = max(1, round(seconds / (t[1] - t[0])))
    return numpy.convolve(values, numpy.ones(count) / count, "valid")


def mean_error(played):
    """Largest error of the weight's 30 s mean, as a share of the set point."""
    return abs(means(played.bit("wob"), played.t, 30.0) / WEIGHT - 1.0).max()


def within_limits(played):
    """1: the 30 s mean of the true weight stays within 10 % and the motor does not stall; else 0."""
    return float(mean_error(played) < 0.1 and not played.truth("motor_stalled").any())


def lost_weight(played):
    """Of the weight that the surface shows, the share that does not come down to the bit."""
    surface, bit = played.readings("surface_wob").mean(), played.bit("wob").mean()
    return float(1.0 - bit / surface) if surface > 1e3 else None


def margin_to_fracture(played):
    """What is left between the largest ECD and the mud weight that opens the rock [kg/m3]; below 0 mud is lost."""
    return float(FRACTURE - played.truth("ecd").max())
