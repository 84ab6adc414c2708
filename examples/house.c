/* The visibility library from C: a house of two rooms with a yard. Prints the visits of an eye in the yard, first with the
   inner door open, then with it closed. */
#include <limen/visibility.h>

#include <stdio.h>
#include <stdlib.h>

enum { YARD, HALL, PARLOUR };
static const char* const names[] = {"yard", "hall", "parlour"};

/* Both sides of the front door, in y = 0, and of the inner door, in y = 5. Corners are counter-clockwise as seen from the
   space that the portal leads out of. */
static const limen_vec3 corners[] = {{1, 0, 0}, {3, 0, 0}, {3, 0, 2}, {1, 0, 2}, /* seen from the yard */
                                     {3, 0, 0}, {1, 0, 0}, {1, 0, 2}, {3, 0, 2}, /* seen from the hall */
                                     {1, 5, 0}, {3, 5, 0}, {3, 5, 2}, {1, 5, 2},
                                     {3, 5, 0}, {1, 5, 0}, {1, 5, 2}, {3, 5, 2}};
static limen_portal portals[] = {{YARD, HALL, LIMEN_NONE, 0, 4, 1},
                                 {HALL, YARD, LIMEN_NONE, 4, 4, 1},
                                 {HALL, PARLOUR, LIMEN_NONE, 8, 4, 1},
                                 {PARLOUR, HALL, LIMEN_NONE, 12, 4, 1}};
static const limen_space spaces[] = {{0, 1, YARD}, {1, 2, HALL}, {3, 1, PARLOUR}}; /* first portal, portals, zone */

static void check(limen_status status, const limen_error* error) {
    if (status != LIMEN_OK) {
        fprintf(stderr, "house: %s\n", error->text);
        exit(2);
    }
}

static void printVisits(limen_flood* flood, const limen_graph* graph, const uint8_t* closed, const limen_view* view) {
    limen_error error;
    limen_counts counts;
    limen_visit visits[16];
    uint32_t i;
    check(limen_flood_run(flood, graph, closed, closed != NULL ? 4 : 0, view, &counts, &error), &error);
    if (limen_flood_visits(flood, visits, 16) != LIMEN_OK)
        exit(2);
    for (i = 0; i < counts.visits; ++i) {
        limen_rect rect;
        if (limen_region_scissor(flood, i, 1920, 1080, &rect) != LIMEN_OK)
            exit(2);
        printf("%*s%s: %u x %u pixels at %u, %u\n", (int)(2 * visits[i].depth), "",
               (visits[i].flags & LIMEN_VISIT_SHUT) != 0 ? "closed door" : names[visits[i].space], rect.width,
               rect.height, rect.x, rect.y);
    }
}

int main(void) {
    const limen_vec3 eye = {2, -2, 1.6}, target = {2, 10, 1.6}, up = {0, 0, 1};
    const uint8_t closed[4] = {0, 0, 1, 1};
    limen_graph* graph;
    limen_flood* flood;
    limen_view view;
    limen_error error;
    check(limen_pair_portals(portals, 4, corners, 16, 0.01, NULL, &error), &error);
    check(limen_graph_create(spaces, 3, portals, 4, corners, 16, &graph, &error), &error);
    check(limen_flood_create(&flood, &error), &error);
    check(limen_look_at(eye, target, up, 60, 16.0 / 9.0, YARD, &view, &error), &error);
    printf("the inner door is open\n");
    printVisits(flood, graph, NULL, &view);
    printf("the inner door is closed\n");
    printVisits(flood, graph, closed, &view);
    limen_flood_destroy(flood);
    limen_graph_destroy(graph);
    return 0;
}
