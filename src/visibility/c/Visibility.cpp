#include "visibility/c/visibility.h"

#include "visibility/Flood.h"
#include "visibility/Movement.h"
#include "visibility/Pairing.h"
#include "visibility/RegionPixels.h"
#include "visibility/RegionPlanes.h"
#include "visibility/ZoneCheck.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace vis = limen::visibility;

struct limen_graph {
    vis::Graph graph;
};

struct limen_flood {
    vis::FloodScratch scratch;
    vis::VisibleSet set;
    vis::View view;
};

namespace {

static_assert(LIMEN_NONE == vis::kNone && LIMEN_NONE == vis::kNoZone);

limen_status report(limen_status status, const std::string& text, limen_error* error) {
    if (error != nullptr) {
        error->status = status;
        const std::size_t length = std::min(text.size(), sizeof error->text - 1);
        std::memcpy(error->text, text.data(), length);
        error->text[length] = '\0';
    }
    return status;
}

/// Calls `function`, which gives a status. No exception leaves it: the standard library throws where memory ends.
template <class Function>
limen_status guarded(limen_error* error, Function&& function) {
    limen_status status = LIMEN_INTERNAL;
    try {
        status = function();
        if (status == LIMEN_OK && error != nullptr) {
            error->status = LIMEN_OK;
            error->text[0] = '\0';
        }
        return status;
    } catch (const std::bad_alloc&) {
        status = LIMEN_OUT_OF_MEMORY;
    } catch (const std::length_error&) {
        status = LIMEN_OUT_OF_MEMORY;
    } catch (...) {
        status = LIMEN_INTERNAL;
    }
    if (error != nullptr) {
        error->status = status;
        std::strncpy(error->text, limen_status_text(status), sizeof error->text - 1);
        error->text[sizeof error->text - 1] = '\0';
    }
    return status;
}

limen_status refuse(const std::string& text, limen_error* error) {
    return report(LIMEN_BAD_ARGUMENT, text, error);
}

limen::Vec3 in(const limen_vec3& v) {
    return {v.x, v.y, v.z};
}
limen_vec3 out(const limen::Vec3& v) {
    return {v.x, v.y, v.z};
}
std::vector<limen::Vec3> in(const limen_vec3* vertices, std::size_t count) {
    std::vector<limen::Vec3> copies(count);
    std::transform(vertices, vertices + count, copies.begin(), [](const limen_vec3& v) { return in(v); });
    return copies;
}
vis::PortalDesc in(const limen_portal& portal) {
    vis::PortalDesc desc;
    desc.space = portal.space;
    desc.destination = portal.destination;
    desc.reciprocal = portal.reciprocal;
    desc.firstVertex = portal.first_vertex;
    desc.vertexCount = portal.vertex_count;
    desc.exact = portal.is_exact != 0;
    return desc;
}
std::vector<vis::PortalDesc> in(const limen_portal* portals, std::size_t count) {
    std::vector<vis::PortalDesc> copies(count);
    std::transform(portals, portals + count, copies.begin(), [](const limen_portal& p) { return in(p); });
    return copies;
}
vis::View in(const limen_view& view) {
    vis::View given;
    given.eye = in(view.eye);
    given.right = in(view.right);
    given.up = in(view.up);
    given.forward = in(view.forward);
    given.tanHalfX = view.tan_half_x;
    given.tanHalfY = view.tan_half_y;
    given.root = view.root;
    return given;
}
std::span<const std::uint8_t> in(const std::uint8_t* closed, std::size_t count) {
    return closed == nullptr ? std::span<const std::uint8_t>() : std::span<const std::uint8_t>(closed, count);
}

limen_visit out(const vis::Visit& visit) {
    limen_visit given{};
    given.zone = visit.zone;
    given.space = visit.space;
    given.parent = visit.parent;
    given.portal = visit.portal;
    given.first_vertex = visit.firstVertex;
    given.vertex_count = visit.vertexCount;
    given.depth = visit.depth;
    given.flags |= visit.hole ? LIMEN_VISIT_HOLE : 0;
    given.flags |= visit.shut ? LIMEN_VISIT_SHUT : 0;
    given.flags |= visit.narrowed ? LIMEN_VISIT_NARROWED : 0;
    const limen::Plane& plane = visit.entryPlane;
    const double values[4] = {plane.n.x, plane.n.y, plane.n.z, plane.d};
    std::copy(values, values + 4, given.entry_plane);
    return given;
}
limen_seen out(const vis::SeenSpace& seen) {
    return {seen.space, seen.visit, seen.rect.minX, seen.rect.minY, seen.rect.maxX, seen.rect.maxY};
}

/// Copies results to the caller's array.
template <class From, class To>
limen_status copyOut(const std::vector<From>& from, To* to, std::size_t capacity) {
    if (from.size() > capacity)
        return LIMEN_TOO_SMALL;
    if (to == nullptr && !from.empty())
        return LIMEN_BAD_ARGUMENT;
    std::transform(from.begin(), from.end(), to, [](const From& item) { return out(item); });
    return LIMEN_OK;
}

bool hasVisit(const limen_flood* flood, std::uint32_t visit) {
    return flood != nullptr && visit < flood->set.visits.size();
}

} // namespace

const char* limen_status_text(limen_status status) {
    switch (status) {
    case LIMEN_OK:
        return "no error";
    case LIMEN_BAD_ARGUMENT:
        return "an argument is null or out of range";
    case LIMEN_OUT_OF_MEMORY:
        return "there is not enough memory";
    case LIMEN_TOO_SMALL:
        return "the given array has too few elements";
    default:
        return "the library has a fault";
    }
}

std::uint32_t limen_version(void) {
    return LIMEN_VERSION_MAJOR * 65536u + LIMEN_VERSION_MINOR * 256u + LIMEN_VERSION_PATCH;
}

limen_status limen_graph_create(const limen_space* spaces, size_t space_count, const limen_portal* portals,
                                size_t portal_count, const limen_vec3* vertices, size_t vertex_count,
                                limen_graph** graph, limen_error* error) {
    return guarded(error, [&] {
        if (graph == nullptr)
            return refuse("graph is null", error);
        *graph = nullptr;
        if ((spaces == nullptr && space_count > 0) || (portals == nullptr && portal_count > 0) ||
            (vertices == nullptr && vertex_count > 0))
            return refuse("an array is null and has elements", error);
        std::vector<vis::SpaceDesc> descs;
        descs.reserve(space_count);
        for (std::size_t i = 0; i < space_count; ++i)
            descs.push_back({spaces[i].first_portal, spaces[i].portal_count, spaces[i].zone});
        auto built = vis::Graph::build(descs, in(portals, portal_count), in(vertices, vertex_count));
        if (!built)
            return refuse(built.error().message(), error);
        *graph = new limen_graph{*std::move(built)};
        return static_cast<limen_status>(LIMEN_OK);
    });
}

void limen_graph_destroy(limen_graph* graph) {
    delete graph;
}

limen_status limen_graph_check_zones(const limen_graph* graph, const limen_wall* walls, size_t wall_count,
                                     const limen_vec3* vertices, size_t vertex_count, limen_error* error) {
    return guarded(error, [&] {
        if (graph == nullptr)
            return refuse("graph is null", error);
        if ((walls == nullptr && wall_count > 0) || (vertices == nullptr && vertex_count > 0))
            return refuse("an array is null and has elements", error);
        std::vector<vis::WallDesc> descs;
        descs.reserve(wall_count);
        for (std::size_t i = 0; i < wall_count; ++i)
            descs.push_back({walls[i].space, walls[i].first_vertex, walls[i].vertex_count});
        const auto checked = vis::checkZones(graph->graph, descs, in(vertices, vertex_count));
        return checked ? static_cast<limen_status>(LIMEN_OK) : refuse(checked.error().message(), error);
    });
}

limen_status limen_pair_portals(limen_portal* portals, size_t portal_count, const limen_vec3* vertices,
                                size_t vertex_count, double tolerance, uint32_t* single, limen_error* error) {
    return guarded(error, [&] {
        if ((portals == nullptr && portal_count > 0) || (vertices == nullptr && vertex_count > 0))
            return refuse("an array is null and has elements", error);
        std::vector<vis::PortalDesc> descs = in(portals, portal_count);
        const auto pairing = vis::pairReciprocals(descs, in(vertices, vertex_count), tolerance);
        if (!pairing)
            return refuse(pairing.error().message(), error);
        for (std::size_t i = 0; i < portal_count; ++i) {
            portals[i].reciprocal = descs[i].reciprocal;
            portals[i].is_exact = descs[i].exact ? 1 : 0;
        }
        if (single != nullptr)
            *single = pairing->single;
        return static_cast<limen_status>(LIMEN_OK);
    });
}

limen_status limen_move(const limen_graph* graph, const uint8_t* closed, size_t closed_count, uint32_t space,
                        limen_vec3 from, limen_vec3 to, limen_movement* movement, limen_error* error) {
    return guarded(error, [&] {
        if (graph == nullptr || movement == nullptr)
            return refuse("graph or movement is null", error);
        if (closed != nullptr && closed_count != graph->graph.portals().size())
            return refuse("closed does not have one byte for each portal", error);
        const vis::Movement moved =
            vis::spaceAfterMove(graph->graph, in(closed, closed_count), space, in(from), in(to));
        if (moved.space == vis::kNone)
            return refuse("space is no space of the graph, or a position is not finite", error);
        *movement = {moved.space, moved.stoppedBy, moved.fraction};
        return static_cast<limen_status>(LIMEN_OK);
    });
}

limen_status limen_look_at(limen_vec3 eye, limen_vec3 target, limen_vec3 up, double height_degrees,
                           double aspect, uint32_t root, limen_view* view, limen_error* error) {
    return guarded(error, [&] {
        if (view == nullptr)
            return refuse("view is null", error);
        const auto made = vis::viewOf({in(eye), in(target), in(up), height_degrees, aspect, root});
        if (!made)
            return refuse(made.error().message(), error);
        *view = {out(made->eye), out(made->right), out(made->up), out(made->forward),
                 made->tanHalfX, made->tanHalfY,   made->root,    0};
        return static_cast<limen_status>(LIMEN_OK);
    });
}

limen_status limen_flood_create(limen_flood** flood, limen_error* error) {
    return guarded(error, [&] {
        if (flood == nullptr)
            return refuse("flood is null", error);
        *flood = nullptr;
        *flood = new limen_flood;
        return static_cast<limen_status>(LIMEN_OK);
    });
}

void limen_flood_destroy(limen_flood* flood) {
    delete flood;
}

limen_status limen_flood_run(limen_flood* flood, const limen_graph* graph, const uint8_t* closed,
                             size_t closed_count, const limen_view* view, limen_counts* counts,
                             limen_error* error) {
    if (flood != nullptr)
        flood->set.clear();
    const limen_status status = guarded(error, [&] {
        if (flood == nullptr || graph == nullptr || view == nullptr)
            return refuse("flood, graph or view is null", error);
        flood->view = in(*view);
        vis::Limits limits;
        if (view->max_visits > 0)
            limits.maxVisits = view->max_visits;
        const auto flooded = vis::flood(graph->graph, in(closed, closed_count), flood->view, limits,
                                        flood->scratch, flood->set);
        if (!flooded)
            return refuse(flooded.error().message(), error);
        if (counts != nullptr)
            *counts = {static_cast<std::uint32_t>(flood->set.visits.size()),
                       static_cast<std::uint32_t>(flood->set.regionVertices.size()),
                       static_cast<std::uint32_t>(flood->set.seen.size()), flood->set.counts.visitsCut};
        return static_cast<limen_status>(LIMEN_OK);
    });
    if (status != LIMEN_OK && flood != nullptr)
        flood->set.clear(); // no part of a result
    return status;
}

limen_status limen_flood_visits(const limen_flood* flood, limen_visit* visits, size_t capacity) {
    return flood == nullptr ? LIMEN_BAD_ARGUMENT : copyOut(flood->set.visits, visits, capacity);
}

limen_status limen_flood_vertices(const limen_flood* flood, limen_vec3* vertices, size_t capacity) {
    return flood == nullptr ? LIMEN_BAD_ARGUMENT : copyOut(flood->set.regionVertices, vertices, capacity);
}

limen_status limen_flood_seen(const limen_flood* flood, limen_seen* seen, size_t capacity) {
    return flood == nullptr ? LIMEN_BAD_ARGUMENT : copyOut(flood->set.seen, seen, capacity);
}

limen_status limen_flood_pixels(const limen_flood* flood, uint32_t width, uint32_t height, uint32_t* visits,
                                size_t capacity) {
    return guarded(nullptr, [&]() -> limen_status {
        if (flood == nullptr || visits == nullptr)
            return LIMEN_BAD_ARGUMENT;
        if (capacity < std::size_t{width} * height)
            return LIMEN_TOO_SMALL;
        std::vector<std::uint32_t> found;
        vis::visitOfPixels(flood->set, width, height, found);
        std::copy(found.begin(), found.end(), visits);
        return LIMEN_OK;
    });
}

limen_status limen_region_scissor(const limen_flood* flood, uint32_t visit, uint32_t width, uint32_t height,
                                  limen_rect* rect) {
    if (!hasVisit(flood, visit) || rect == nullptr)
        return LIMEN_BAD_ARGUMENT;
    const vis::PixelRect found = vis::scissorOf(flood->set.region(flood->set.visits[visit]), width, height);
    *rect = {found.x, found.y, found.width, found.height};
    return LIMEN_OK;
}

limen_status limen_region_planes(const limen_flood* flood, uint32_t visit, double (*planes)[4],
                                 size_t capacity, size_t* count) {
    return guarded(nullptr, [&]() -> limen_status {
        if (!hasVisit(flood, visit) || (planes == nullptr && capacity > 0) || count == nullptr)
            return LIMEN_BAD_ARGUMENT;
        std::vector<limen::Plane> found;
        vis::clipPlanesOf(flood->set.region(flood->set.visits[visit]), flood->view, capacity, found);
        for (std::size_t i = 0; i < found.size(); ++i) {
            const double values[4] = {found[i].n.x, found[i].n.y, found[i].n.z, found[i].d};
            std::copy(values, values + 4, planes[i]);
        }
        *count = found.size();
        return LIMEN_OK;
    });
}

limen_status limen_region_triangles(const limen_flood* flood, uint32_t visit, float (*positions)[4],
                                    size_t capacity, size_t* count) {
    return guarded(nullptr, [&]() -> limen_status {
        if (!hasVisit(flood, visit) || (positions == nullptr && capacity > 0) || count == nullptr)
            return LIMEN_BAD_ARGUMENT;
        std::vector<limen::Vec4f> found;
        vis::trianglesOf(flood->set.region(flood->set.visits[visit]), found);
        *count = found.size();
        if (found.size() > capacity)
            return LIMEN_TOO_SMALL;
        for (std::size_t i = 0; i < found.size(); ++i) {
            const float values[4] = {found[i].x, found[i].y, found[i].z, found[i].w};
            std::copy(values, values + 4, positions[i]);
        }
        return LIMEN_OK;
    });
}
