"""Checks the pictures of examples/frame and examples/overlay: a lit room, and on one of them an orange triangle."""
import struct
import zlib

ORANGE = (255, 128, 0)


def picture(path):
    """Width, and the rows of (r, g, b), of a PNG with eight bits a channel."""
    data = path.read_bytes()
    width, height, depth, kind = struct.unpack(">IIBB", data[16:26])
    channels = {2: 3, 6: 4}[kind]
    assert data[:8] == b"\x89PNG\r\n\x1a\n" and depth == 8
    packed, at = b"", 8
    while at < len(data):
        length, name = struct.unpack(">I4s", data[at:at + 8])
        if name == b"IDAT":
            packed += data[at + 8:at + 8 + length]
        at += 12 + length
    raw, stride = zlib.decompress(packed), width * channels
    rows, before = [], bytearray(stride)
    for y in range(height):
        rule, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            left = row[i - channels] if i >= channels else 0
            row[i] = (row[i] + predicted(rule, left, before[i], before[i - channels] if i >= channels else 0)) & 255
        rows.append([tuple(row[i:i + 3]) for i in range(0, stride, channels)])
        before = row
    return rows


def predicted(rule, left, above, corner):
    """The filters of PNG: none, left, above, mean, Paeth."""
    if rule == 4:
        order = (left, above, corner)
        distances = (abs(above - corner), abs(left - corner), abs(left + above - 2 * corner))
        return order[distances.index(min(distances))]
    return (0, left, above, (left + above) // 2)[rule]


def faults_of_room(name, rows):
    """A line for each expectation of a picture of a lit room that does not hold."""
    if (len(rows), len(rows[0])) != (360, 640):
        yield f"{name}: {len(rows[0])}x{len(rows)} pixels"
    colours = len({pixel for row in rows for pixel in row})
    if colours < 1000:
        yield f"{name}: {colours} colours only; a lit room has more"


def faults(plain, overlaid):
    """A line for each expectation that does not hold."""
    frame, both = picture(plain), picture(overlaid)
    yield from faults_of_room("frame", frame)
    yield from faults_of_room("overlay", both)
    orange = [(x, y) for y, row in enumerate(both) for x, pixel in enumerate(row) if pixel == ORANGE]
    if not 3400 < len(orange) < 3510 or not all(30 < x < 130 and 265 < y < 345 for x, y in orange):
        yield f"overlay: {len(orange)} orange pixels, where the triangle has 3,456"
    if any(pixel == ORANGE for row in frame for pixel in row):
        yield "frame: it has pixels of the triangle's colour; the comparison means nothing"
    # Both show the same place; they differ in the triangle, and in what has another time or distance.
    equal = sum(a == b for first, second in zip(frame, both) for a, b in zip(first, second))
    if equal < 200_000:
        yield f"overlay: only {equal} of 230,400 pixels equal those of the picture without a window"
