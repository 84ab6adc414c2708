/* The C interface, used from C99. The program prints each expectation that fails; its exit code is 1 if there is one. */
#include "limen/visibility.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failures = 0;

#define EXPECT(condition)                                                                                    \
    do {                                                                                                     \
        if (!(condition)) {                                                                                  \
            fprintf(stderr, "%s:%d: expected: %s\n", __FILE__, __LINE__, #condition);                        \
            ++failures;                                                                                      \
        }                                                                                                    \
    } while (0)

/* A yard, a hall and a parlour in a row along y; doors in y = 0 and y = 5. */
static const limen_vec3 vertices[] = {{1, 0, 0}, {3, 0, 0}, {3, 0, 2}, {1, 0, 2},  /* yard to hall */
                                      {3, 0, 0}, {1, 0, 0}, {1, 0, 2}, {3, 0, 2},  /* back */
                                      {1, 5, 0}, {3, 5, 0}, {3, 5, 2}, {1, 5, 2},  /* hall to parlour */
                                      {3, 5, 0}, {1, 5, 0}, {1, 5, 2}, {3, 5, 2}}; /* back */
static const limen_space spaces[] = {{0, 1, 0}, {1, 2, 1}, {3, 1, 2}};
static const limen_portal unpaired[] = {{0, 1, LIMEN_NONE, 0, 4, 1},
                                        {1, 0, LIMEN_NONE, 4, 4, 1},
                                        {1, 2, LIMEN_NONE, 8, 4, 1},
                                        {2, 1, LIMEN_NONE, 12, 4, 1}};

static limen_graph* house(void) {
    limen_portal portals[4];
    limen_graph* graph = NULL;
    limen_error error;
    uint32_t single = 9;
    memcpy(portals, unpaired, sizeof portals);
    EXPECT(limen_pair_portals(portals, 4, vertices, 16, 0.01, &single, &error) == LIMEN_OK);
    EXPECT(single == 0 && portals[0].reciprocal == 1 && portals[3].reciprocal == 2 && portals[3].is_exact == 1);
    EXPECT(limen_graph_create(spaces, 3, portals, 4, vertices, 16, &graph, &error) == LIMEN_OK);
    EXPECT(graph != NULL && error.status == LIMEN_OK && error.text[0] == '\0');
    return graph;
}

static limen_view northwards(void) {
    const limen_vec3 eye = {2, -2, 1}, target = {2, 10, 1}, up = {0, 0, 1};
    limen_view view;
    EXPECT(limen_look_at(eye, target, up, 90.0, 1.0, 0, &view, NULL) == LIMEN_OK);
    EXPECT(fabs(view.tan_half_x - 1.0) < 1e-12 && fabs(view.forward.y - 1.0) < 1e-12);
    return view;
}

static void testFlood(void) {
    limen_graph* graph = house();
    limen_flood* flood = NULL;
    const limen_view view = northwards();
    limen_counts counts;
    limen_visit visits[3];
    limen_vec3 corners[16];
    limen_seen seen[3];
    EXPECT(limen_flood_create(&flood, NULL) == LIMEN_OK);
    EXPECT(limen_flood_run(flood, graph, NULL, 0, &view, &counts, NULL) == LIMEN_OK);
    EXPECT(counts.visits == 3 && counts.vertices == 12 && counts.seen == 3 && counts.visits_cut == 0);
    EXPECT(limen_flood_visits(flood, visits, 2) == LIMEN_TOO_SMALL);
    EXPECT(limen_flood_visits(flood, visits, 3) == LIMEN_OK);
    EXPECT(visits[0].parent == LIMEN_NONE && visits[0].space == 0);
    EXPECT(visits[1].space == 1 && visits[1].parent == 0 && visits[1].portal == 0 && visits[1].depth == 1);
    EXPECT(visits[2].space == 2 && visits[2].parent == 1 && visits[2].flags == 0);
    EXPECT(fabs(visits[1].entry_plane[1] - 1.0) < 1e-12 && fabs(visits[1].entry_plane[3] + 2.0) < 1e-12);
    EXPECT(limen_flood_vertices(flood, corners, 16) == LIMEN_OK);
    EXPECT(fabs(corners[visits[1].first_vertex].x / corners[visits[1].first_vertex].z) <= 0.5 + 1e-12);
    EXPECT(limen_flood_seen(flood, seen, 3) == LIMEN_OK);
    EXPECT(seen[1].space == 1 && seen[1].visit == 1 && fabs(seen[1].max_x - 0.5) < 1e-3);
    limen_flood_destroy(flood);
    limen_graph_destroy(graph);
}

static void testClosedDoor(void) {
    limen_graph* graph = house();
    limen_flood* flood = NULL;
    const limen_view view = northwards();
    const uint8_t closed[4] = {0, 0, 1, 0};
    limen_visit visits[3];
    limen_counts counts;
    EXPECT(limen_flood_create(&flood, NULL) == LIMEN_OK);
    EXPECT(limen_flood_run(flood, graph, closed, 4, &view, &counts, NULL) == LIMEN_OK && counts.visits == 3);
    EXPECT(limen_flood_visits(flood, visits, 3) == LIMEN_OK);
    EXPECT(visits[2].flags == (LIMEN_VISIT_HOLE | LIMEN_VISIT_SHUT) && visits[2].space == LIMEN_NONE);
    limen_flood_destroy(flood);
    limen_graph_destroy(graph);
}

static void testRegions(void) {
    limen_graph* graph = house();
    limen_flood* flood = NULL;
    const limen_view view = northwards();
    uint32_t pixels[64], inHall = 0, i;
    limen_rect rect;
    double planes[8][4];
    float positions[8][4];
    size_t count = 0;
    EXPECT(limen_flood_create(&flood, NULL) == LIMEN_OK);
    EXPECT(limen_flood_run(flood, graph, NULL, 0, &view, NULL, NULL) == LIMEN_OK);
    EXPECT(limen_flood_pixels(flood, 8, 8, pixels, 63) == LIMEN_TOO_SMALL);
    EXPECT(limen_flood_pixels(flood, 8, 8, pixels, 64) == LIMEN_OK);
    for (i = 0; i < 64; ++i)
        inHall += pixels[i] >= 1 ? 1 : 0;
    EXPECT(inHall == 16); /* the door is half as wide and half as high as the screen */
    EXPECT(pixels[0] == 0 && pixels[27] >= 1);
    EXPECT(limen_region_scissor(flood, 1, 8, 8, &rect) == LIMEN_OK);
    EXPECT(rect.x == 2 && rect.y == 2 && rect.width == 4 && rect.height == 4);
    EXPECT(limen_region_planes(flood, 1, planes, 8, &count) == LIMEN_OK && count == 4);
    for (i = 0; i < 4; ++i) /* the middle of the parlour is inside */
        EXPECT(planes[i][0] * 2 + planes[i][1] * 7 + planes[i][2] * 1 + planes[i][3] > 0);
    EXPECT(limen_region_planes(flood, 1, planes, 2, &count) == LIMEN_OK && count == 2);
    EXPECT(limen_region_triangles(flood, 1, positions, 5, &count) == LIMEN_TOO_SMALL && count == 6);
    EXPECT(limen_region_triangles(flood, 1, positions, 8, &count) == LIMEN_OK && count == 6);
    EXPECT(fabs(fabs(positions[0][0] / positions[0][3]) - 0.5) < 1e-6);
    EXPECT(limen_region_scissor(flood, 3, 8, 8, &rect) == LIMEN_BAD_ARGUMENT);
    limen_flood_destroy(flood);
    limen_graph_destroy(graph);
}

static void testMove(void) {
    limen_graph* graph = house();
    const limen_vec3 yard = {2, -2, 1}, parlour = {2, 7, 1}, nowhere = {NAN, 0, 0};
    const uint8_t closed[4] = {0, 0, 1, 0};
    limen_movement moved;
    limen_error error;
    EXPECT(limen_move(graph, NULL, 0, 0, yard, parlour, &moved, NULL) == LIMEN_OK);
    EXPECT(moved.space == 2 && moved.fraction == 1.0 && moved.stopped_by == LIMEN_NONE);
    EXPECT(limen_move(graph, closed, 4, 0, yard, parlour, &moved, NULL) == LIMEN_OK);
    EXPECT(moved.space == 1 && moved.stopped_by == 2 && fabs(moved.fraction - 7.0 / 9.0) < 1e-12);
    EXPECT(limen_move(graph, closed, 3, 0, yard, parlour, &moved, &error) == LIMEN_BAD_ARGUMENT);
    EXPECT(limen_move(graph, NULL, 0, 7, yard, parlour, &moved, NULL) == LIMEN_BAD_ARGUMENT);
    EXPECT(limen_move(graph, NULL, 0, 0, yard, nowhere, &moved, NULL) == LIMEN_BAD_ARGUMENT);
    limen_graph_destroy(graph);
}

/* The yard and the parlour touch in y = 9 and are in one zone; a hatch in it leads from the yard to the hall. */
static void testZones(void) {
    static const limen_vec3 corners[] = {{1, 9, 0}, {3, 9, 0}, {3, 9, 2}, {1, 9, 2},  /* yard to hall */
                                         {8, 0, 0}, {8, 2, 0}, {8, 2, 2}, {8, 0, 2},  /* yard to parlour */
                                         {8, 2, 0}, {8, 0, 0}, {8, 0, 2}, {8, 2, 2},  /* back */
                                         {0, 9, 0}, {4, 9, 0}, {4, 9, 3}, {0, 9, 3}}; /* a wall of the parlour */
    static const limen_space zoned[] = {{0, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    static const limen_portal portals[] = {{0, 1, LIMEN_NONE, 0, 4, 1}, {0, 2, 2, 4, 4, 1}, {2, 0, 1, 8, 4, 1}};
    static const limen_wall walls[] = {{2, 12, 4}};
    limen_graph* graph = NULL;
    limen_error error;
    EXPECT(limen_graph_create(zoned, 3, portals, 3, corners, 16, &graph, &error) == LIMEN_OK);
    EXPECT(limen_graph_check_zones(graph, NULL, 0, NULL, 0, &error) == LIMEN_OK && error.status == LIMEN_OK);
    EXPECT(limen_graph_check_zones(graph, walls, 1, corners, 16, &error) == LIMEN_BAD_ARGUMENT);
    EXPECT(strcmp(error.text, "portal 0, from space 0 to space 1: leads out of the zone, and a wall of space 2, which is in "
                              "the same zone, is right behind it; give space 2 a zone of its own") == 0);
    EXPECT(limen_graph_check_zones(graph, walls, 1, corners, 15, &error) == LIMEN_BAD_ARGUMENT);
    EXPECT(strcmp(error.text, "wall 0: has vertices outside the array") == 0);
    EXPECT(limen_graph_check_zones(graph, NULL, 1, corners, 16, NULL) == LIMEN_BAD_ARGUMENT);
    EXPECT(limen_graph_check_zones(NULL, walls, 1, corners, 16, NULL) == LIMEN_BAD_ARGUMENT);
    limen_graph_destroy(graph);
}

static void testErrors(void) {
    limen_graph* graph = house();
    limen_graph* other = graph;
    limen_flood* flood = NULL;
    limen_view view = northwards();
    limen_portal portals[4];
    limen_counts counts;
    limen_visit visits[1];
    limen_error error;
    memset(&error, 'x', sizeof error);
    memcpy(portals, unpaired, sizeof portals);
    portals[2].destination = 7;
    EXPECT(limen_graph_create(spaces, 3, portals, 4, vertices, 16, &other, &error) == LIMEN_BAD_ARGUMENT);
    EXPECT(other == NULL && error.status == LIMEN_BAD_ARGUMENT);
    EXPECT(strcmp(error.text, "portal 2: names a space that does not exist") == 0);
    EXPECT(limen_graph_create(NULL, 3, portals, 4, vertices, 16, &other, NULL) == LIMEN_BAD_ARGUMENT);
    EXPECT(limen_graph_create(spaces, 3, portals, 4, vertices, 16, NULL, &error) == LIMEN_BAD_ARGUMENT);
    EXPECT(limen_graph_create(spaces, 3, portals, 4, vertices, SIZE_MAX / 8, &other, &error) == LIMEN_OUT_OF_MEMORY);
    EXPECT(strcmp(error.text, limen_status_text(LIMEN_OUT_OF_MEMORY)) == 0);
    EXPECT(limen_pair_portals(portals, 4, vertices, 3, 0.01, NULL, NULL) == LIMEN_BAD_ARGUMENT);
    EXPECT(limen_pair_portals(portals, 4, vertices, 16, -1.0, NULL, NULL) == LIMEN_BAD_ARGUMENT);
    EXPECT(limen_flood_create(NULL, &error) == LIMEN_BAD_ARGUMENT);
    EXPECT(limen_flood_create(&flood, NULL) == LIMEN_OK);
    EXPECT(limen_flood_run(flood, NULL, NULL, 0, &view, &counts, &error) == LIMEN_BAD_ARGUMENT);
    EXPECT(limen_flood_run(flood, graph, NULL, 0, &view, &counts, &error) == LIMEN_OK);
    view.root = 3;
    EXPECT(limen_flood_run(flood, graph, NULL, 0, &view, &counts, &error) == LIMEN_BAD_ARGUMENT);
    EXPECT(strcmp(error.text, "view of a flood: root 3 is not one of the 3 spaces") == 0);
    EXPECT(limen_flood_visits(flood, visits, 1) == LIMEN_OK); /* no result is left */
    EXPECT(limen_flood_visits(NULL, visits, 1) == LIMEN_BAD_ARGUMENT);
    view.up = view.forward;
    view.root = 0;
    EXPECT(limen_flood_run(flood, graph, NULL, 0, &view, NULL, NULL) == LIMEN_BAD_ARGUMENT);
    EXPECT(limen_look_at(view.eye, view.eye, view.up, 90, 1, 0, &view, NULL) == LIMEN_BAD_ARGUMENT);
    EXPECT(strlen(limen_status_text(99)) > 0);
    EXPECT(limen_version() == LIMEN_VERSION_MAJOR * 65536 + LIMEN_VERSION_MINOR * 256 + LIMEN_VERSION_PATCH);
    limen_flood_destroy(flood);
    limen_flood_destroy(NULL);
    limen_graph_destroy(graph);
    limen_graph_destroy(NULL);
}

/* A program compiled with these headers must work with the next library of the same soname. */
static void testLayout(void) {
    EXPECT(sizeof(limen_wall) == 12 && sizeof(limen_space) == 12 && sizeof(limen_portal) == 24 && sizeof(limen_vec3) == 24);
    EXPECT(sizeof(limen_view) == 120 && offsetof(limen_view, tan_half_x) == 96 && offsetof(limen_view, root) == 112);
    EXPECT(sizeof(limen_visit) == 64 && offsetof(limen_visit, entry_plane) == 32);
    EXPECT(sizeof(limen_seen) == 40 && sizeof(limen_counts) == 16 && sizeof(limen_rect) == 16);
    EXPECT(sizeof(limen_movement) == 16 && sizeof(limen_error) == 256);
}

int main(void) {
    testFlood();
    testClosedDoor();
    testRegions();
    testMove();
    testZones();
    testErrors();
    testLayout();
    if (failures == 0)
        puts("the C interface works");
    return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
