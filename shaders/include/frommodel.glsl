// Eye-relative corners and planes of an instance's triangles, the same for drawing and for culling them.
#include "transform.glsl"

// A baked mesh has its block's origin, and its vertices go the openings' way. Of any other the origin goes that way, and what
// is turned is added: its vertices would be rounded to floats of the block (0.01 mm) on the way.
vec3 eyeFromModel(vec3 position, vec3 rest, Instance instance) {
    vec3 origin = vec3(instance.row0.w, instance.row1.w, instance.row2.w);
    vec4 row0 = vec4(instance.row0.xyz, 0.0);
    vec4 row1 = vec4(instance.row1.xyz, 0.0);
    vec4 row2 = vec4(instance.row2.xyz, 0.0);
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
    vec3 normal = vec3(dot(cross(instance.row1.xyz, instance.row2.xyz), facet),
                       dot(cross(instance.row2.xyz, instance.row0.xyz), facet),
                       dot(cross(instance.row0.xyz, instance.row1.xyz), facet));
    float size = length(normal);
    normal = size > 0.0 ? normal / size : vec3(0.0);
    return vec4(normal, dot(normal, through));
}
