# SPDX-License-Identifier: Apache-2.0
"""Compares the ink of a drawing with the truth about it, by the same measures as bench/part_score.hpp."""

import dataclasses

import numpy

BESIDE = 0.4  # mm, slightly less than the width of a wide line
TOUCHING = 0.1  # mm between ends of lines that meet
STEP = 0.25  # mm between samples
AROUND = 2  # mm to each side of the place of an error
SAME_SIZE = 0.01  # by how much of its size a drawing of the right scale may be larger or smaller


@dataclasses.dataclass
class Score:
    recall: float  # of the visible lines, the fraction with visible ink beside it
    precision: float  # of the visible ink, the fraction beside visible lines
    recall_hidden: float  # of the hidden lines, the fraction with any ink beside it
    precision_hidden: float  # of the hidden ink, the fraction beside any line
    loose_ends: int  # of visible ink
    strokes: int  # segments of visible and hidden ink joined end to end
    errors: dict  # mm of lines and of ink without a counterpart, and around which place most of them lie


def samples_of(lines):
    """Points about STEP apart, and the length for which each stands."""
    length = numpy.linalg.norm(lines[:, 2:] - lines[:, :2], axis=1)
    count = numpy.maximum(1, (length / STEP).astype(int))
    row = numpy.repeat(numpy.arange(len(lines)), count)
    nth = numpy.arange(len(row)) - numpy.repeat(numpy.cumsum(count) - count, count)
    share = ((nth + 0.5) / count[row])[:, None]
    return lines[row, :2] * (1 - share) + lines[row, 2:] * share, length[row] / count[row]


def near(points, lines, distance, own=None):
    """Whether a line, other than that of the number `own`, passes within the distance of each point."""
    found = numpy.zeros(len(points), bool)
    if len(lines) == 0:
        return found
    low, high = numpy.minimum(lines[:, :2], lines[:, 2:]) - distance, numpy.maximum(lines[:, :2], lines[:, 2:]) + distance
    order = numpy.argsort(points[:, 0])
    across = points[order, 0]
    first, last = numpy.searchsorted(across, low[:, 0]), numpy.searchsorted(across, high[:, 0], "right")
    beside = (low[:, 1] <= points[:, 1].max()) & (high[:, 1] >= points[:, 1].min()) if len(points) else False
    for i in numpy.nonzero((first < last) & beside)[0]:
        line, at = lines[i], order[first[i]:last[i]]
        at = at[~found[at] & (points[at, 1] >= low[i, 1]) & (points[at, 1] <= high[i, 1])]
        if own is not None:
            at = at[own[at] != i]
        if len(at) == 0:
            continue
        along = line[2:] - line[:2]
        square = along @ along
        share = numpy.clip((points[at] - line[:2]) @ along / square, 0, 1) if square else numpy.zeros(len(at))
        found[at] = numpy.linalg.norm(points[at] - line[:2] - share[:, None] * along, axis=1) <= distance
    return found


def share_beside(lines, others):
    if len(lines) == 0:
        return 1.0
    points, weights = samples_of(lines)
    return float(weights[near(points, others, BESIDE)].sum() / weights.sum())


def worst(lines, others):
    """Of what does not lie beside the others: how many mm there are, and around which place most of them."""
    points, weights = samples_of(lines)
    bad = ~near(points, others, BESIDE)
    points, weights = points[bad], weights[bad]
    if len(points) == 0:
        return 0.0, None
    around = [weights[numpy.abs(points - point).max(1) < AROUND].sum() for point in points]
    return float(weights.sum()), points[int(numpy.argmax(around))]


def loose_ends(lines):
    ends, own = lines.reshape(-1, 2), numpy.repeat(numpy.arange(len(lines)), 2)
    return int((~near(ends, lines, TOUCHING, own)).sum())


def strokes(lines):
    """Chains of segments, where ends at which exactly two meet are joined."""
    meeting = {}
    for i, line in enumerate(numpy.round(lines / (TOUCHING / 10)).astype(int)):
        for end in (tuple(line[:2]), tuple(line[2:])):
            meeting.setdefault(end, []).append(i)
    chain = list(range(len(lines)))

    def root(i):
        while chain[i] != i:
            chain[i] = chain[chain[i]]
            i = chain[i]
        return i

    for pair in meeting.values():
        if len(pair) == 2:
            chain[root(pair[0])] = root(pair[1])
    return sum(root(i) == i for i in range(len(lines)))


def corners_of(lines):
    return lines.reshape(-1, 2).min(0), lines.reshape(-1, 2).max(0)


def placed(ink, lines):
    """The (visible, hidden) ink, which may stand anywhere on its sheet, at the place of the truth; an error if it has another size."""
    visible, hidden = ink
    (low, high), (ink_low, ink_high) = corners_of(numpy.concatenate((lines["visible"], lines["smooth_visible"]))), corners_of(visible)
    size, ink_size = high - low, ink_high - ink_low
    if numpy.any(numpy.abs(ink_size - size) > SAME_SIZE * size.max()):
        raise ValueError("%.1f x %.1f mm instead of %.1f x %.1f" % (*ink_size, *size))
    move = numpy.tile((low + high - ink_low - ink_high) / 2, 2)
    return visible + move, hidden + move


def score(ink, truth):
    lines = {kind: numpy.array(rows, float).reshape(-1, 4) for kind, rows in truth.items()}
    visible, hidden = placed(ink, lines)
    may_be_seen = numpy.concatenate((lines["visible"], lines["smooth_visible"]))
    may_be_hidden = numpy.concatenate((may_be_seen, lines["hidden"], lines["smooth_hidden"]))
    all_ink = numpy.concatenate((visible, hidden))
    errors = {"missing": worst(lines["visible"], visible), "wrong": worst(visible, may_be_seen),
              "hidden missing": worst(lines["hidden"], all_ink), "hidden wrong": worst(hidden, may_be_hidden)}
    return Score(share_beside(lines["visible"], visible), share_beside(visible, may_be_seen), share_beside(lines["hidden"], all_ink),
                 share_beside(hidden, may_be_hidden), loose_ends(visible), strokes(visible) + strokes(hidden), errors)
