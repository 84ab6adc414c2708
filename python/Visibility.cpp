#include "Module.h"

#include "visibility/Flood.h"
#include "visibility/GraphBuilder.h"
#include "visibility/MeshGraph.h"
#include "visibility/Movement.h"
#include "visibility/RegionPixels.h"
#include "visibility/RegionPlanes.h"
#include "visibility/SpaceLocator.h"
#include "visibility/ZoneCheck.h"

#include <memory>

namespace limen::python {

namespace {

namespace vis = visibility;

/// An array of any layout that can become doubles, or numbers, in rows.
template <class T>
using Array = py::array_t<T, py::array::c_style | py::array::forcecast>;

Vec3 vectorOf(const Array<double>& array) {
    if (array.ndim() != 1 || array.shape(0) != 3)
        throw Raised("a position or direction has three numbers");
    return {array.at(0), array.at(1), array.at(2)};
}

std::vector<Vec3> vectorsOf(const Array<double>& array, const char* name) {
    if (array.ndim() != 2 || array.shape(1) != 3)
        throw Raised(std::string(name) + " must have the shape (n, 3)");
    std::vector<Vec3> vectors;
    for (py::ssize_t i = 0; i < array.shape(0); ++i)
        vectors.emplace_back(array.at(i, 0), array.at(i, 1), array.at(i, 2));
    return vectors;
}

Array<double> rowsOf(std::span<const Vec3> vectors) {
    Array<double> rows({static_cast<py::ssize_t>(vectors.size()), py::ssize_t{3}});
    auto out = rows.mutable_unchecked<2>();
    for (std::size_t i = 0; i < vectors.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            out(static_cast<py::ssize_t>(i), axis) = vectors[i][axis];
    return rows;
}

/// A visit and a seen space as elements of NumPy arrays.
struct VisitRow {
    std::uint32_t zone, space, parent, portal, first_vertex, vertex_count, depth;
    bool hole, shut, narrowed;
    double plane_x, plane_y, plane_z, plane_d;
};
struct SeenRow {
    std::uint32_t space, visit;
    double min_x, min_y, max_x, max_y;
};

VisitRow rowOf(const vis::Visit& v) {
    const Plane& p = v.entryPlane;
    return {v.zone, v.space, v.parent,   v.portal, v.firstVertex, v.vertexCount, v.depth,
            v.hole, v.shut,  v.narrowed, p.n.x,    p.n.y,         p.n.z,         p.d};
}
SeenRow rowOf(const vis::SeenSpace& s) {
    return {s.space, s.visit, s.rect.minX, s.rect.minY, s.rect.maxX, s.rect.maxY};
}

template <class Row, class Item>
py::array_t<Row> tableOf(const std::vector<Item>& items) {
    py::array_t<Row> table(static_cast<py::ssize_t>(items.size()));
    Row* out = table.mutable_data();
    for (const Item& item : items)
        *out++ = rowOf(item);
    return table;
}

/// Working memory and the last result.
struct Flood {
    vis::FloodScratch scratch;
    vis::VisibleSet set;
    vis::View view;

    [[nodiscard]] std::span<const Vec3> region(std::size_t visit) const {
        if (visit >= set.visits.size())
            throw py::index_error("there is no visit " + std::to_string(visit));
        return set.region(set.visits[visit]);
    }
};

void run(Flood& flood, const vis::Graph& graph, const vis::View& view,
         const std::optional<Array<std::uint8_t>>& closed, std::uint32_t maxVisits) {
    vis::Limits limits;
    limits.maxVisits = maxVisits;
    std::span<const std::uint8_t> states;
    if (closed)
        states = {closed->data(), static_cast<std::size_t>(closed->size())};
    flood.view = view;
    valueOf(vis::flood(graph, states, view, limits, flood.scratch, flood.set));
}

py::array_t<std::uint32_t> pixelsOf(const Flood& flood, std::uint32_t width, std::uint32_t height) {
    std::vector<std::uint32_t> found;
    vis::visitOfPixels(flood.set, width, height, found);
    py::array_t<std::uint32_t> pixels({static_cast<py::ssize_t>(height), static_cast<py::ssize_t>(width)});
    std::copy(found.begin(), found.end(), pixels.mutable_data());
    return pixels;
}

Array<double> planesOf(const Flood& flood, std::size_t visit, std::size_t most) {
    std::vector<Plane> planes;
    vis::clipPlanesOf(flood.region(visit), flood.view, most, planes);
    Array<double> rows({static_cast<py::ssize_t>(planes.size()), py::ssize_t{4}});
    auto out = rows.mutable_unchecked<2>();
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const Vec4 row(planes[i].n, planes[i].d);
        for (int c = 0; c < 4; ++c)
            out(static_cast<py::ssize_t>(i), c) = row[c];
    }
    return rows;
}

Array<float> trianglesOf(const Flood& flood, std::size_t visit) {
    std::vector<Vec4f> corners;
    vis::trianglesOf(flood.region(visit), corners);
    Array<float> rows({static_cast<py::ssize_t>(corners.size()), py::ssize_t{4}});
    auto out = rows.mutable_unchecked<2>();
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (int c = 0; c < 4; ++c)
            out(static_cast<py::ssize_t>(i), c) = corners[i][c];
    return rows;
}

/// Meshes as (vertices, corners, faces), which the spans of SpaceMesh point into.
struct Meshes {
    std::vector<std::vector<Vec3>> vertices;
    std::vector<std::vector<std::uint32_t>> corners;
    std::vector<std::vector<vis::MeshFace>> faces;
    std::vector<vis::SpaceMesh> views;
};

using MeshTuple = std::tuple<Array<double>, Array<std::uint32_t>, Array<std::uint32_t>>;

Meshes meshesOf(const std::vector<MeshTuple>& given) {
    Meshes meshes;
    for (const auto& [vertices, corners, faces] : given) {
        meshes.vertices.push_back(vectorsOf(vertices, "vertices"));
        meshes.corners.emplace_back(corners.data(), corners.data() + corners.size());
        if (faces.ndim() != 2 || faces.shape(1) != 3)
            throw Raised("faces must have the shape (n, 3): first corner, number of corners, opening");
        std::vector<vis::MeshFace>& list = meshes.faces.emplace_back();
        for (py::ssize_t i = 0; i < faces.shape(0); ++i)
            list.push_back({faces.at(i, 0), faces.at(i, 1), faces.at(i, 2)});
    }
    for (std::size_t i = 0; i < given.size(); ++i)
        meshes.views.push_back({meshes.vertices[i], meshes.corners[i], meshes.faces[i]});
    return meshes;
}

void checkZones(const vis::Graph& graph, const std::vector<std::pair<std::uint32_t, Array<double>>>& given) {
    std::vector<vis::WallDesc> walls;
    std::vector<Vec3> vertices;
    for (const auto& [space, polygon] : given) {
        const std::vector<Vec3> corners = vectorsOf(polygon, "the polygon of a wall");
        walls.push_back(
            {space, static_cast<std::uint32_t>(vertices.size()), static_cast<std::uint32_t>(corners.size())});
        vertices.insert(vertices.end(), corners.begin(), corners.end());
    }
    valueOf(vis::checkZones(graph, walls, vertices));
}

void addGraphs(py::module_& m) {
    py::class_<vis::Graph>(m, "Graph", "Spaces joined by portals. Made by GraphBuilder or graph_from_meshes.")
        .def_property_readonly("space_count", [](const vis::Graph& g) { return g.spaces().size(); })
        .def_property_readonly("portal_count", [](const vis::Graph& g) { return g.portals().size(); })
        .def(
            "polygon",
            [](const vis::Graph& g, std::size_t portal) {
                if (portal >= g.portals().size())
                    throw py::index_error("there is no portal " + std::to_string(portal));
                return rowsOf(g.polygon(g.portals()[portal]));
            },
            py::arg("portal"),
            "The corners of a portal, shape (n, 3), counter-clockwise seen from inside its space.")
        .def("check_zones", &checkZones,
             py::arg("walls") = std::vector<std::pair<std::uint32_t, Array<double>>>{},
             "Checks the zones of several spaces, as far as portals and walls show their faults. `walls`: "
             "tuples of\n"
             "a space and its polygon, shape (n, 3). Raises an error that names the portal and the spaces.");
    py::class_<vis::GraphBuilder>(m, "GraphBuilder", "Collects spaces and openings, in any order.")
        .def(py::init<>())
        .def("add_space", &vis::GraphBuilder::addSpace,
             "Adds a space, in a zone of its own, and returns its number.")
        .def("add_space_in_zone_of", &vis::GraphBuilder::addSpaceInZoneOf, py::arg("other"),
             "Adds a space to the zone of an earlier one, and returns its number. Depth alone decides inside "
             "a zone:\n"
             "its spaces are closed, disjoint, and connected by exact pairs of portals. See "
             "Graph.check_zones.")
        .def(
            "add_opening",
            [](vis::GraphBuilder& builder, std::uint32_t from, std::uint32_t to, const Array<double>& polygon,
               const std::optional<Array<double>>& back, bool oneWay) {
                return builder.addOpening({from, to, vectorsOf(polygon, "polygon"),
                                           back ? vectorsOf(*back, "back_polygon") : std::vector<Vec3>{},
                                           oneWay});
            },
            py::arg("from_space"), py::arg("to_space") = vis::kNone, py::arg("polygon"),
            py::arg("back_polygon") = py::none(), py::arg("one_way") = false,
            "Adds an opening. Its polygon is counter-clockwise seen from inside `from_space`.")
        .def(
            "build",
            [](const vis::GraphBuilder& builder) {
                vis::BuiltGraph built = valueOf(builder.build());
                Array<std::uint32_t> openings(
                    {static_cast<py::ssize_t>(built.openings.size()), py::ssize_t{2}});
                auto out = openings.mutable_unchecked<2>();
                for (std::size_t i = 0; i < built.openings.size(); ++i) {
                    out(static_cast<py::ssize_t>(i), 0) = built.openings[i].out;
                    out(static_cast<py::ssize_t>(i), 1) = built.openings[i].back;
                }
                return std::pair(std::move(built.graph), openings);
            },
            "The graph, and for each opening the numbers of its two portals, shape (n, 2); NONE: there is "
            "none.");
    m.def(
        "graph_from_meshes",
        [](const std::vector<MeshTuple>& given, double tolerance, bool outside) {
            const Meshes meshes = meshesOf(given);
            vis::MeshGraph made = valueOf(vis::graphFromMeshes(meshes.views, {tolerance, outside}));
            std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>> openings;
            for (const vis::MeshOpening& o : made.openings)
                openings.emplace_back(o.mesh, o.opening, o.portal, o.destination);
            return std::pair(std::move(made.graph), openings);
        },
        py::arg("meshes"), py::arg("tolerance") = vis::kPairTolerance, py::arg("outside") = false,
        "A graph from closed meshes: tuples of vertices (n, 3), corners (n,) and faces (n, 3): first corner, "
        "number of corners,\n"
        "opening (NONE: a wall). Also gives the openings as tuples (mesh, opening, portal, destination).");
    py::class_<vis::SpaceLocator>(m, "SpaceLocator",
                                  "Finds the space that contains a point, from closed meshes.")
        .def(py::init([](const std::vector<MeshTuple>& given, double tolerance) {
                 const Meshes meshes = meshesOf(given);
                 return valueOf(vis::SpaceLocator::build(meshes.views, tolerance));
             }),
             py::arg("meshes"), py::arg("tolerance") = vis::kPairTolerance)
        .def(
            "space_at",
            [](const vis::SpaceLocator& locator, const Array<double>& point) {
                return locator.spaceAt(vectorOf(point));
            },
            py::arg("point"), "The lowest space that contains the point; NONE if none does.");
    m.def(
        "space_after_move",
        [](const vis::Graph& graph, std::uint32_t space, const Array<double>& from, const Array<double>& to) {
            const vis::Movement moved = vis::spaceAfterMove(graph, {}, space, vectorOf(from), vectorOf(to));
            return std::pair(moved.space, moved.fraction);
        },
        py::arg("graph"), py::arg("space"), py::arg("start"), py::arg("end"),
        "The space at the end of a straight movement, and the share of the way up to a portal that stops "
        "it.");
}

void addFloods(py::module_& m) {
    py::class_<vis::View>(m, "View", "An eye and its perspective. Made by look_at.")
        .def_readwrite("root", &vis::View::root);
    m.def(
        "look_at",
        [](const Array<double>& eye, const Array<double>& target, std::uint32_t root, const Array<double>& up,
           double height, double aspect) {
            return valueOf(
                vis::viewOf({vectorOf(eye), vectorOf(target), vectorOf(up), height, aspect, root}));
        },
        py::arg("eye"), py::arg("target"), py::arg("root"), py::arg("up") = std::vector<double>{0, 0, 1},
        py::arg("height_degrees") = 60.0, py::arg("aspect") = 16.0 / 9.0,
        "A view from `eye`, which is in space `root`, to `target`.");
    py::class_<Flood>(m, "Flood", "The working memory of floods, and the result of the last one.")
        .def(py::init<>())
        .def("run", &run, py::arg("graph"), py::arg("view"), py::arg("closed") = py::none(),
             py::arg("max_visits") = vis::Limits().maxVisits,
             "Floods the graph. `closed`: one number a portal, not 0 closes it.")
        .def_property_readonly(
            "visits", [](const Flood& f) { return tableOf<VisitRow>(f.set.visits); },
            "The visits in drawing order, a structured array.")
        .def_property_readonly(
            "seen", [](const Flood& f) { return tableOf<SeenRow>(f.set.seen); },
            "The spaces that may be seen, by visit, a structured array.")
        .def(
            "region", [](const Flood& f, std::size_t visit) { return rowsOf(f.region(visit)); },
            py::arg("visit"), "The region of a visit: corners (x, y, w), shape (n, 3).")
        .def("pixels", &pixelsOf, py::arg("width"), py::arg("height"),
             "The visit of each pixel, shape (height, width), row 0 at the bottom; NONE: none.")
        .def(
            "scissor",
            [](const Flood& f, std::size_t visit, std::uint32_t width, std::uint32_t height) {
                const vis::PixelRect r = vis::scissorOf(f.region(visit), width, height);
                return std::tuple(r.x, r.y, r.width, r.height);
            },
            py::arg("visit"), py::arg("width"), py::arg("height"),
            "x, y, width and height in pixels, row 0 at the bottom.")
        .def("planes", &planesOf, py::arg("visit"), py::arg("most") = std::size_t{6},
             "At most `most` planes around the region, shape (n, 4): normal and distance, positive inside.")
        .def("triangles", &trianglesOf, py::arg("visit"),
             "The region as triangles in clip space, shape (3 n, 4).");
}

} // namespace

void addVisibility(py::module_& module) {
    PYBIND11_NUMPY_DTYPE(VisitRow, zone, space, parent, portal, first_vertex, vertex_count, depth, hole, shut,
                         narrowed, plane_x, plane_y, plane_z, plane_d);
    PYBIND11_NUMPY_DTYPE(SeenRow, space, visit, min_x, min_y, max_x, max_y);
    module.attr("NONE") = vis::kNone;
    addGraphs(module);
    addFloods(module);
}

} // namespace limen::python
