// Eye-relative corners and planes of an instance's triangles, identical for drawing and culling.
#include "transform.glsl"

// A baked mesh has the block's origin, and its vertices take the same path as the corners of openings. For any other
// instance only the origin takes that path, and the turned vertex is added. Otherwise vertices would be rounded to
// block-local floats (0.01 mm).
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

// Plane of a triangle with this model-space normal through a point, eye-relative. Normals transform by the cofactor
// matrix. A mirroring pose reverses the winding, and the cofactors reverse the normal with it.
vec4 facetFromModel(vec3 facet, Instance instance, vec3 through) {
    mat3 rows = rowsOf(instance);
    vec3 normal = vec3(dot(cross(rows[1], rows[2]), facet), dot(cross(rows[2], rows[0]), facet),
                       dot(cross(rows[0], rows[1]), facet));
    float size = length(normal);
    normal = size > 0.0 ? normal / size : vec3(0.0);
    return vec4(normal, dot(normal, through));
}
