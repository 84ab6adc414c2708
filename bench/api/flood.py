"""flood.py MODULES HOUSE RESULT REPEATS: floods a house from its eyes, as `limen bench api` does in C++.

Writes the seconds of processor time of each repeat, and the visits and seen spaces of each eye, as numbers. Exit code 3: there is no
module `limen`, neither in the folder MODULES nor in those of Python.
"""
import json
import sys
import time

sys.path.insert(0, sys.argv[1])
try:
    import limen.visibility as vis
except ImportError:
    sys.exit(3)

with open(sys.argv[2], encoding="utf-8") as file:
    house = json.load(file)
builder = vis.GraphBuilder()
for _ in range(house["spaces"]):
    builder.add_space()
for start, end, polygon in house["openings"]:
    builder.add_opening(start, end, polygon=polygon)
graph, _ = builder.build()
views = [vis.look_at(eye, target, root, height_degrees=height, aspect=aspect) for eye, target, root, height, aspect in house["eyes"]]

flood = vis.Flood()


def flood_all():
    for view in views:
        flood.run(graph, view)
        flood.visits
        flood.seen


seconds = []
for repeat in range(int(sys.argv[4]) + 2):  # two to warm up
    start = time.thread_time()
    flood_all()
    seconds.append(time.thread_time() - start)

results = []
for view in views:
    flood.run(graph, view)
    visits, seen = flood.visits, flood.seen
    results.append([len(visits), len(seen)] + [int(visit[name]) for visit in visits for name in ("space", "parent", "portal")] +
                   [int(space["space"]) for space in seen])
with open(sys.argv[3], "w", encoding="utf-8") as file:
    json.dump({"seconds": seconds[2:], "results": results}, file)
