"""Tests of the Python module: python3 module_test.py, with the module on PYTHONPATH."""
import pathlib
import tempfile
import unittest

import numpy as np

import limen
import limen.dat
import limen.visibility as vis

UP = np.array([0, 0, 2.0])


def doorway(y):
    """Counter-clockwise as seen from the south."""
    a, b = np.array([1, y, 0.0]), np.array([3, y, 0.0])
    return np.array([a, b, b + UP, a + UP])


def house():
    builder = vis.GraphBuilder()
    yard, hall, parlour = builder.add_space(), builder.add_space(), builder.add_space()
    builder.add_opening(yard, hall, doorway(0))
    builder.add_opening(hall, parlour, doorway(5))
    return builder.build()


def northwards():
    return vis.look_at([2, -2, 1], [2, 10, 1], root=0, height_degrees=90, aspect=1)


class Visibility(unittest.TestCase):
    def test_flood(self):
        graph, openings = house()
        self.assertEqual((graph.space_count, graph.portal_count), (3, 4))
        flood = vis.Flood()
        flood.run(graph, northwards())
        visits = flood.visits
        self.assertEqual(list(visits["space"]), [0, 1, 2])
        self.assertEqual(list(visits["parent"]), [vis.NONE, 0, 1])
        self.assertEqual(visits["portal"][1], openings[0, 0])
        self.assertAlmostEqual(visits["plane_y"][1], 1.0)
        self.assertEqual(list(flood.seen["space"]), [0, 1, 2])
        region = flood.region(1)
        np.testing.assert_allclose(np.abs(region[:, :2] / region[:, 2:]), 0.5)

    def test_closed(self):
        graph, openings = house()
        closed = np.zeros(graph.portal_count, dtype=bool)
        closed[openings[1]] = True
        flood = vis.Flood()
        flood.run(graph, northwards(), closed)
        self.assertTrue(flood.visits["shut"][2])
        with self.assertRaisesRegex(limen.Error, "3 states for 4 portals"):
            flood.run(graph, northwards(), closed[:3])

    def test_regions(self):
        graph, _ = house()
        flood = vis.Flood()
        flood.run(graph, northwards())
        pixels = flood.pixels(8, 4)
        self.assertEqual(pixels.shape, (4, 8))
        self.assertEqual(np.count_nonzero(pixels >= 1), 8)
        self.assertEqual(flood.scissor(1, 8, 8), (2, 2, 4, 4))
        planes = flood.planes(1)
        self.assertEqual(planes.shape, (4, 4))
        self.assertTrue(np.all(planes @ [2, 7, 1, 1] > 0))
        self.assertEqual(len(flood.planes(1, most=2)), 2)
        self.assertEqual(flood.triangles(1).shape, (6, 4))
        with self.assertRaises(IndexError):
            flood.region(3)

    def test_zones(self):
        builder = vis.GraphBuilder()
        a = builder.add_space()
        b, attic = builder.add_space_in_zone_of(a), builder.add_space()
        builder.add_opening(a, b, doorway(-9))
        builder.add_opening(a, attic, doorway(4))
        graph, openings = builder.build()
        graph.check_zones()
        wall = np.array([[0, 4, 0], [4, 4, 0], [4, 4, 3], [0, 4, 3]], dtype=float)
        graph.check_zones([(a, wall), (b, wall + [0, 0.01, 0])])
        with self.assertRaisesRegex(limen.Error, f"portal {openings[1, 0]}, from space 0 to space 2: .* a wall of space 1"):
            graph.check_zones([(a, wall), (b, wall)])
        with self.assertRaisesRegex(limen.Error, "wall 1: names a space"):
            graph.check_zones([(a, wall), (9, wall)])

    def test_errors(self):
        builder = vis.GraphBuilder()
        builder.add_space()
        builder.add_opening(0, 4, doorway(0))
        with self.assertRaisesRegex(limen.Error, "none is number 4"):
            builder.build()
        with self.assertRaisesRegex(limen.Error, r"shape \(n, 3\)"):
            builder.add_opening(0, 0, np.zeros((4, 2)))
        with self.assertRaisesRegex(limen.Error, "target is in the eye"):
            vis.look_at([0, 0, 0], [0, 0, 0], root=0)
        self.assertTrue(issubclass(limen.Error, ValueError))

    def test_meshes(self):
        corners = np.array([[x, y, z] for z in (0, 3) for y in (0, 4) for x in (0, 4)], dtype=float)
        quads = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]], dtype=np.uint32)
        faces = np.array([[4 * i, 4, vis.NONE] for i in range(6)], dtype=np.uint32)
        west, east = faces.copy(), faces.copy()
        west[5, 2] = 1  # the whole wall at x = 4 is an opening
        east[4, 2] = 2
        meshes = [(corners, quads.ravel(), west), (corners + [4, 0, 0], quads.ravel(), east)]
        graph, openings = vis.graph_from_meshes(meshes)
        self.assertEqual([(o[0], o[1], o[3]) for o in openings], [(0, 1, 1), (1, 2, 0)])
        self.assertEqual(vis.space_after_move(graph, 0, [2, 2, 1], [6, 2, 1]), (1, 1.0))
        locator = vis.SpaceLocator(meshes)
        self.assertEqual([locator.space_at([x, 2, 1]) for x in (2, 6, 9)], [0, 1, vis.NONE])
        self.assertEqual(graph.polygon(0).shape, (4, 3))


class Dat(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = str(pathlib.Path(self.folder.name) / "client_portal.dat")
        palette = np.concatenate([[0x04000001, 2], [0xFF000000, 0xFFFFFFFF]]).astype("<u4").tobytes()
        writer = limen.dat.Writer()
        writer.add(0x04000001, palette)
        writer.add(0x04000002, b"\x02\x00\x00\x04" + palette[4:], compressed=True)
        writer.write(self.path)
        self.palette = palette

    def tearDown(self):
        self.folder.cleanup()

    def test_reading(self):
        file = limen.dat.File(self.path)
        self.assertEqual(list(file.entries()["id"][:2]), [0x04000001, 0x04000002])
        self.assertEqual(file.read(0x04000001), self.palette)
        self.assertEqual(file.kind(0x04000001), "Palette")
        self.assertEqual(file.record(0x04000002)["id"], "0x04000002")
        with self.assertRaisesRegex(limen.Error, "0x04000009"):
            file.read(0x04000009)
        with self.assertRaisesRegex(limen.Error, "no picture"):
            file.pixels(0x04000001)
        with self.assertRaises(limen.Error):
            limen.dat.File(self.path + ".absent")

    def test_verify(self):
        report = limen.dat.verify([self.path])
        self.assertEqual(report["records"]["Palette"], 2)
        self.assertEqual(report["faults"], [])
        writer = limen.dat.Writer()
        writer.add(0x04000001, self.palette[:-1])
        writer.write(self.path)
        self.assertEqual([fault[1] for fault in limen.dat.verify([self.path])["faults"]], [0x04000001])


if __name__ == "__main__":
    unittest.main()
