// Eye-relative corners and planes of an instance's triangles, the same for drawing and for culling them.
#include "transform.glsl"

// A baked mesh has its block's origin, and its vertices go the openings' way. Of any other the origin goes that way, and what
// is turned is added: its vertices would be rounded to floats of the block (0.01 mm) on the way.
vec3 eyeFromModel(vec3 position, vec3 rest, Instance instance) {
    vec3 origin = originOf(instance);
    mat3 rows = rowsOf(instance);
    vec4 row0 = vec4(rows[0], 0.0);
    vec4 row1 = vec4(rows[1], 0.0);
    vec4 row2 = vec4(rows[2], 0.0);
    vec3 turned = blockFromModel(position, row0, row1, row2);
    vec3 turnedRest = blockFromModel(rest, row0, row1, row2);
    bool isBaked = origin == vec3(0.0);
    precise vec3 start = eyeFromBlock(isBaked ? turned : origin, turnedRest, instance.block);
    precise vec3 result = isBaked ? start : start + turned;
    return result;
}

vec3 eyeFromVertex(uint vertex, Instance instance) {
    return eyeFromModel(cornerAt(vertex), cornerRestAt(vertex), instance);
}

// The plane of a triangle with this normal through a point, eye-relative. Planes turn with the cofactors of a matrix; a
// mirroring one turns the winding over, and the normal with it.
vec4 facetFromModel(vec3 facet, Instance instance, vec3 through) {
    mat3 rows = rowsOf(instance);
    vec3 normal = vec3(dot(cross(rows[1], rows[2]), facet), dot(cross(rows[2], rows[0]), facet),
                       dot(cross(rows[0], rows[1]), facet));
    float size = length(normal);
    normal = size > 0.0 ? normal / size : vec3(0.0);
    return vec4(normal, dot(normal, through));
}
