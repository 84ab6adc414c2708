#ifndef LIMEN_VISIBILITY_H
#define LIMEN_VISIBILITY_H

/* Portal visibility from C: which spaces an eye sees, and through which parts of the screen.

   Handles are opaque. Results go into the caller's arrays. No function keeps a pointer that it was given, throws, or ends
   the program; null and wrong arguments give an error. A handle may be used by one thread at a time; a graph may also be
   read by several. Lengths are metres, matrices and coordinates double. Screen coordinates are homogeneous (x, y, w): x
   to the right and y up, on the screen for |x| <= w, |y| <= w. See docs/ray-rule.md for the rule that a flood follows. */

#include "limen/version.h"

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32) && defined(LIMEN_BUILDS_SHARED)
#define LIMEN_C_API __declspec(dllexport)
#elif defined(_WIN32) && defined(LIMEN_SHARED)
#define LIMEN_C_API __declspec(dllimport)
#elif defined(_WIN32)
#define LIMEN_C_API
#else
#define LIMEN_C_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Errors ---------------------------------------------------------------------------------------------------- */

typedef int32_t limen_status;
enum {
    LIMEN_OK = 0,
    LIMEN_BAD_ARGUMENT = 1,  /* null, an index out of range, a view without axes, ... */
    LIMEN_OUT_OF_MEMORY = 2, /* the handle is unchanged, or has no result */
    LIMEN_TOO_SMALL = 3,     /* the caller's array has too few elements; nothing was written to it */
    LIMEN_INTERNAL = 4       /* a fault of the library */
};

/* The status as one sentence. Never null. */
LIMEN_C_API const char* limen_status_text(limen_status status);

/* Receives the reason of a failure, cut to its size, with a zero at the end. May be null wherever it is taken. */
typedef struct limen_error {
    limen_status status;
    char text[252];
} limen_error;

/* The version of the library that runs: major * 65536 + minor * 256 + patch. limen/version.h has that of the header. */
LIMEN_C_API uint32_t limen_version(void);

/* ---- Graphs ---------------------------------------------------------------------------------------------------- */

#define LIMEN_NONE UINT32_MAX

typedef struct limen_vec3 {
    double x, y, z;
} limen_vec3;

/* A space: a run of portals, and its zone. Give each space a zone of its own, unless all spaces of the zone are closed,
   disjoint, connected by exact pairs of portals, and none has a wall or a portal right behind an opening that leads out of
   the zone from another space. limen_graph_check_zones finds such faults. */
typedef struct limen_space {
    uint32_t first_portal, portal_count;
    uint32_t zone;
} limen_space;

/* An opening that leads out of `space`. */
typedef struct limen_portal {
    uint32_t space;
    uint32_t destination;                /* LIMEN_NONE: leads nowhere */
    uint32_t reciprocal;                 /* the portal back through the same opening; LIMEN_NONE: one-way */
    uint32_t first_vertex, vertex_count; /* flat, convex, counter-clockwise seen from inside `space` */
    uint32_t is_exact; /* 0: the reciprocal has another polygon, and the opening is where both are */
} limen_portal;

typedef struct limen_graph limen_graph;

/* Checks and copies the arrays. On success `*graph` is a handle to destroy. */
LIMEN_C_API limen_status limen_graph_create(const limen_space* spaces, size_t space_count,
                                            const limen_portal* portals, size_t portal_count,
                                            const limen_vec3* vertices, size_t vertex_count,
                                            limen_graph** graph, limen_error* error);
/* Null is allowed. */
LIMEN_C_API void limen_graph_destroy(limen_graph* graph);

/* A wall of `space`: a flat run of corners; may be non-convex; in either winding. */
typedef struct limen_wall {
    uint32_t space;
    uint32_t first_vertex, vertex_count;
} limen_wall;

/* Checks the zones of several spaces, as far as portals and walls show their faults: LIMEN_BAD_ARGUMENT, naming the portal and the
   spaces of the first one. Without walls, portals alone are compared. Not checked: that the spaces are closed and disjoint. */
LIMEN_C_API limen_status limen_graph_check_zones(const limen_graph* graph, const limen_wall* walls,
                                                 size_t wall_count, const limen_vec3* vertices,
                                                 size_t vertex_count, limen_error* error);

/* Finds the reciprocal of each portal that has none, and sets `reciprocal` and `is_exact` of both. `tolerance`: metres
   between equal corners, e.g. 0.01. `single` receives the number of portals that stay one-way; may be null. */
LIMEN_C_API limen_status limen_pair_portals(limen_portal* portals, size_t portal_count,
                                            const limen_vec3* vertices, size_t vertex_count, double tolerance,
                                            uint32_t* single, limen_error* error);

/* The end of a straight movement from `from`, in `space`, to `to`, through open portals. */
typedef struct limen_movement {
    uint32_t space;
    uint32_t stopped_by; /* a portal that is closed or leads nowhere; LIMEN_NONE: none */
    double fraction;     /* of the way */
} limen_movement;

/* `closed`: one byte a portal, not 0 closes it; null: all open. */
LIMEN_C_API limen_status limen_move(const limen_graph* graph, const uint8_t* closed, size_t closed_count,
                                    uint32_t space, limen_vec3 from, limen_vec3 to, limen_movement* movement,
                                    limen_error* error);

/* ---- Floods ---------------------------------------------------------------------------------------------------- */

typedef struct limen_view {
    limen_vec3 eye;                /* in the frame of the vertices */
    limen_vec3 right, up, forward; /* orthonormal */
    double tan_half_x, tan_half_y; /* tangents of half the field of view */
    uint32_t root;                 /* the space the eye is in */
    uint32_t max_visits;           /* 0: the default, 32,768 */
} limen_view;

/* A view from `eye` to `target`. `height_degrees`: the vertical field of view; `aspect`: width by height. */
LIMEN_C_API limen_status limen_look_at(limen_vec3 eye, limen_vec3 target, limen_vec3 up,
                                       double height_degrees, double aspect, uint32_t root, limen_view* view,
                                       limen_error* error);

enum {
    LIMEN_VISIT_HOLE = 1,    /* the rays end at the opening: it leads nowhere, or is closed */
    LIMEN_VISIT_SHUT = 2,    /* a hole, because the opening is closed */
    LIMEN_VISIT_NARROWED = 4 /* of an inexact pair */
};

/* A visit of the eye's rays to a space, or to a zone of several. */
typedef struct limen_visit {
    uint32_t zone, space;    /* LIMEN_NONE for a hole */
    uint32_t parent, portal; /* the visit and the portal it was entered from; LIMEN_NONE for the root */
    uint32_t first_vertex, vertex_count; /* its region: a run of limen_flood_vertices */
    uint32_t depth;                      /* 0 for the root */
    uint32_t flags;                      /* LIMEN_VISIT_... */
    double entry_plane[4];               /* normal and distance, relative to the eye; positive beyond */
} limen_visit;

/* A space that may be seen in a visit, and the rectangle of the screen, in NDC, that bounds it. */
typedef struct limen_seen {
    uint32_t space, visit;
    double min_x, min_y, max_x, max_y;
} limen_seen;

typedef struct limen_counts {
    uint32_t visits, vertices, seen;
    uint32_t visits_cut; /* left out because of max_visits */
} limen_counts;

/* The working memory of floods, and the result of the last one. */
typedef struct limen_flood limen_flood;

LIMEN_C_API limen_status limen_flood_create(limen_flood** flood, limen_error* error);
/* Null is allowed. */
LIMEN_C_API void limen_flood_destroy(limen_flood* flood);

/* Floods the graph. Without an error the result replaces the last one; else there is none. `counts` may be null. */
LIMEN_C_API limen_status limen_flood_run(limen_flood* flood, const limen_graph* graph, const uint8_t* closed,
                                         size_t closed_count, const limen_view* view, limen_counts* counts,
                                         limen_error* error);

/* Copy the last result: visits in drawing order, parents before children; the regions' corners as (x, y, w),
   counter-clockwise; the seen spaces by visit. `capacity`: elements in the caller's array. */
LIMEN_C_API limen_status limen_flood_visits(const limen_flood* flood, limen_visit* visits, size_t capacity);
LIMEN_C_API limen_status limen_flood_vertices(const limen_flood* flood, limen_vec3* vertices,
                                              size_t capacity);
LIMEN_C_API limen_status limen_flood_seen(const limen_flood* flood, limen_seen* seen, size_t capacity);

/* ---- Regions of the last result ----------------------------------------------------------------------------------- */

typedef struct limen_rect {
    uint32_t x, y, width, height; /* pixels, row 0 at the bottom; width 0: empty */
} limen_rect;

/* The visit of each pixel's centre, rows from below, on a screen of width * height pixels. LIMEN_NONE: none. */
LIMEN_C_API limen_status limen_flood_pixels(const limen_flood* flood, uint32_t width, uint32_t height,
                                            uint32_t* visits, size_t capacity);

/* The smallest rectangle with all pixels that the visit's region touches. */
LIMEN_C_API limen_status limen_region_scissor(const limen_flood* flood, uint32_t visit, uint32_t width,
                                              uint32_t height, limen_rect* rect);

/* At most `capacity` planes that bound the visit's region, never cutting it: normal and distance, positive inside, in the
   frame of the eye's coordinates. `count` receives their number. */
LIMEN_C_API limen_status limen_region_planes(const limen_flood* flood, uint32_t visit, double (*planes)[4],
                                             size_t capacity, size_t* count);

/* The visit's region as triangles, three positions (x, y, 0, w) in clip space for each. `count` receives the number of
   positions, also with LIMEN_TOO_SMALL. */
LIMEN_C_API limen_status limen_region_triangles(const limen_flood* flood, uint32_t visit,
                                                float (*positions)[4], size_t capacity, size_t* count);

#ifdef __cplusplus
}
#endif

#endif
