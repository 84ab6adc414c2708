"""Compares pictures of examples/culling: the culled ones equal the one of all rooms, but for pixels at the edge of an opening."""
import re
import subprocess

EDGE = 1.0  # pixels: a region's edge and the wall's own edge round to different pixels
MOST_DIFFERENT = 40  # pixels of 307,200; the edges are about 2,000 pixels long


def picture(path):
    magic, size, _, pixels = path.read_bytes().split(b"\n", 3)
    width, height = map(int, size.split())
    assert magic == b"P6" and len(pixels) == 3 * width * height, path
    return width, height, pixels


def different(first, second):
    """Pixels that differ, as (x, y) from the lower left corner."""
    width, height, a = first
    b = second[2]
    rows = (y for y in range(height) if a[3 * width * y:3 * width * (y + 1)] != b[3 * width * y:3 * width * (y + 1)])
    return [(x + 0.5, height - y - 0.5) for y in rows for x in range(width)
            if a[3 * (width * y + x):3 * (width * y + x + 1)] != b[3 * (width * y + x):3 * (width * y + x + 1)]]


def edges(printed):
    """The edges of the regions that the example prints, as pairs of corners."""
    for line in re.findall(r"^region of \d+: (.*)$", printed, re.MULTILINE):
        numbers = list(map(float, line.split()))
        corners = list(zip(numbers[::2], numbers[1::2]))
        yield from zip(corners, corners[1:] + corners[:1])


def distance(point, edge):
    (ax, ay), (bx, by) = edge
    dx, dy = bx - ax, by - ay
    share = max(0.0, min(1.0, ((point[0] - ax) * dx + (point[1] - ay) * dy) / ((dx * dx + dy * dy) or 1.0)))
    return ((point[0] - ax - share * dx) ** 2 + (point[1] - ay - share * dy) ** 2) ** 0.5


def faults(program, folder, environment):
    """Draws the three pictures, and yields a line for each expectation that does not hold."""
    printed, pictures, triangles = {}, {}, {}
    for way in ("all", "scissor", "stencil"):
        path = folder / f"{way}.ppm"
        done = subprocess.run(["xvfb-run", "-a", program, way, path], capture_output=True, text=True, env=environment)
        if done.returncode != 0:
            yield f"{program} {way}: exit {done.returncode}: {done.stderr}"
            return
        printed[way], pictures[way] = done.stdout, picture(path)
        triangles[way] = int(done.stdout.split()[0])
    width, height, pixels = pictures["all"]
    colours = {pixels[i:i + 3] for i in range(0, len(pixels), 3)}
    if len(colours) < 10:
        yield f"the picture of all rooms has {len(colours)} colours only"
    for way in ("scissor", "stencil"):
        if triangles[way] * 2 > triangles["all"]:
            yield f"{way}: {triangles[way]} of {triangles['all']} triangles are drawn, more than half"
        found = different(pictures["all"], pictures[way])
        far = [point for point in found if min(distance(point, edge) for edge in edges(printed[way])) > EDGE]
        if far or len(found) > MOST_DIFFERENT:
            yield f"{way}: {len(found)} pixels differ, {len(far)} of them off the edges: {far[:5]}"
    # The comparison sees a room that is missing: black pixels in the place of the second region.
    without = bytearray(pixels)
    middle = 3 * (width * (height // 2) + 160)
    without[middle:middle + 30] = bytes(30)
    lost = different(pictures["all"], (width, height, bytes(without)))
    if not any(min(distance(point, edge) for edge in edges(printed["stencil"])) > EDGE for point in lost):
        yield "the comparison does not see pixels of a room that is missing"
