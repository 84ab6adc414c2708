"""The visibility library from Python: floods a house and draws its plan with the visits of one eye.

    python3 plan.py FILE.png

Each cell (# %%) can be run by itself in an editor that knows notebooks.
"""
# %% The house: a garden and three rooms. Each opening is a line on the plan, 2 m high.
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import limen.visibility as vis

ROOMS = {"garden": None, "hall": (0, 0, 4, 5), "parlour": (0, 5, 4, 10), "closet": (4, 5, 8, 10)}
NAMES = list(ROOMS)
# From, to, and the lower corners: as seen from inside the first room, the first corner is on the left.
OPENINGS = [("garden", "hall", (1, 0), (3, 0)), ("hall", "parlour", (1, 5), (3, 5)), ("parlour", "closet", (4, 9), (4, 6))]

builder = vis.GraphBuilder()
for name in NAMES:
    builder.add_space()
for start, end, left, right in OPENINGS:
    corners = np.array([(*left, 0), (*right, 0), (*right, 2), (*left, 2)], dtype=float)
    builder.add_opening(NAMES.index(start), NAMES.index(end), corners)
graph, _ = builder.build()

# %% The flood: an eye in the hall that looks to the north-east.
EYE, TARGET = np.array([1.0, 2.0, 1.6]), np.array([4.0, 8.0, 1.6])
view = vis.look_at(EYE, TARGET, root=NAMES.index("hall"), height_degrees=60, aspect=1.5)
flood = vis.Flood()
flood.run(graph, view)
visits = flood.visits
for index, visit in enumerate(visits):
    print(f"{'  ' * visit['depth']}{NAMES[visit['space']]}: {flood.scissor(index, 1500, 1000)} of 1500 x 1000 pixels")

# %% The plan: rooms, openings, and for each visit the wedge of its rays.
forward = (TARGET - EYE) / np.linalg.norm(TARGET - EYE)
right = np.cross(forward, [0, 0, 1])
right /= np.linalg.norm(right)
TAN_X = np.tan(np.radians(30)) * 1.5  # of half the width of the view

figure, axes = plt.subplots(figsize=(6, 7))
for name, rectangle in ROOMS.items():
    if rectangle:
        x0, y0, x1, y1 = rectangle
        axes.plot([x0, x1, x1, x0, x0], [y0, y0, y1, y1, y0], color="black")
        axes.text(x0 + 0.2, y1 - 0.5, name)
for _, _, left, end in OPENINGS:
    axes.plot(*zip(left, end), color="white", linewidth=4)
for index, visit in enumerate(visits):
    region = flood.region(index)
    sides = region[:, 0] / region[:, 2] * TAN_X
    wedge = [EYE[:2]] + [(EYE + 9 * (forward + right * side))[:2] for side in (sides.min(), sides.max())]
    axes.fill(*zip(*wedge), alpha=0.25, label=f"{index}: {NAMES[visit['space']]}")
axes.plot(*EYE[:2], "o", color="black")
axes.set(aspect="equal", xlim=(-1, 9), ylim=(-2, 11), xlabel="x, metres", ylabel="y, metres")
axes.legend(loc="lower right")
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "plan.png", dpi=80)
