// Light and fog at a vertex (docs/formats/light.md). Light belongs to an instance: outdoors it has the sun and the sky,
// in cells the cells' ambient light and lamps. NO_CELL_FOG, BAKED_LIGHT_REPLACES, SURFACE_DIFFUSE, WALL_GREY,
// NORMALS_SCALED, NORMALS_DIVIDED: other readings than the default (docs/uncertain.md).
#include "transform.glsl"

// Multiples of a lamp's falloff: its reach on the walls of cells and on everything else.
const float kWallReach = 1.3;
const float kThingReach = 1.5;
const float kViewerFalloff = 10.0; // metres
const float kMovingRadius = 1.0;   // metres: of every moving object (src/world/assemble/Lights.cpp)
#ifdef PIXEL_LAMPS
const bool kLightsWalls = false; // at vertices
#else
const bool kLightsWalls = true;
#endif
const float kAtLamp = 1.0e-4;      // metres: nearer to a lamp its direction is undefined

// The light of an instance, before lamps.
struct Incident {
    vec3 ambient;
    vec3 sun; // at a surface that faces it
    uint kind; // LightSet.kind
    uint firstLamp;
    uint lampCount;
};

vec3 unitOrZero(vec3 v) {
    const float least = 1.0e-24; // of a square: 0 stays 0
    return v * inversesqrt(max(dot(v, v), least));
}

// Normal in light of one that the object's pose has turned and scaled.
vec3 litNormal(vec3 turned) {
#if defined(NORMALS_SCALED)
    return turned;
#elif defined(NORMALS_DIVIDED)
    return turned / max(dot(turned, turned), 1.0e-24);
#else
    return unitOrZero(turned);
#endif
}

vec3 cutToBytes(vec3 colour) {
    return floor(clamp(colour, 0.0, 1.0) * 255.0 + 1.0e-3) / 255.0; // rounding must not take a whole step
}

#ifndef FAST
// The member whose zone lights an instance: the root's, else the first.
Member memberThatLights(Instance instance) {
    Member first = memberAt(instance.firstMember);
    uint count = memberCountOf(instance);
    for (uint i = 0u; count > 1u && i < count; ++i) {
        Member each = memberAt(instance.firstMember + i);
        if (each.zone == frame.rootZone) {
            return each;
        }
    }
    return first;
}
#endif

Lamp lampAt(uint number) {
    uint first = device.firstLamp + lampRefs[number] * kLampTexels;
    return Lamp(uintBitsToFloat(ringTexel(first)), uintBitsToFloat(ringTexel(first + 1u)));
}

// Baked light of one lamp at a wall. Surfaces that face away a little are lit, too.
vec3 onWall(Lamp lamp, vec3 at, vec3 normal) {
    vec3 towards = lamp.position.xyz - at;
    float far = max(length(towards), kAtLamp);
    float range = kWallReach * lamp.position.w;
    float facing = (0.5 * far + dot(normal, towards)) / 1.5;
    float falls = far > 1.0 ? far * far * far : far;
    float strength = lamp.colour.w * max(0.0, 1.0 - far / range) * max(0.0, facing) / falls;
    return lamp.colour.rgb * min(strength, 1.0);
}

vec3 onThing(vec3 towards, vec3 colour, float falloff, vec3 normal) {
    float far = max(length(towards), kAtLamp);
    return far < kThingReach * falloff ? colour * (max(0.0, dot(normal, towards)) / (far * far)) : vec3(0.0);
}

vec3 bakedLight(Incident light, vec3 at, vec3 normal) {
    vec3 baked = vec3(0.0);
    for (uint i = 0u; i < light.lampCount; ++i) {
        baked += onWall(lampAt(light.firstLamp + i), at, normal);
    }
    return cutToBytes(baked);
}

// Lamps of an object; `origin`: its place. The viewer's light is one of the greatest number.
vec3 lampLight(Incident light, vec3 at, vec3 normal, vec3 origin) {
    vec3 sum = vec3(0.0);
    uint most = light.kind == kLitMoving ? light.lampCount : kMostLampsOfAThing - (frame.viewerLight.w > 0.0 ? 1u : 0u);
    uint count = min(light.lampCount, most);
    for (uint i = 0u; i < count; ++i) {
        Lamp lamp = lampAt(light.firstLamp + i);
        bool isNear = light.kind == kLitThing || distance(lamp.position.xyz, origin) <= lamp.position.w + kMovingRadius;
        float intensity = isNear ? lamp.colour.w : 0.0;
        sum += onThing(lamp.position.xyz - at, lamp.colour.rgb * intensity, lamp.position.w, normal);
    }
    return sum;
}

vec3 ofViewer(vec3 at, vec3 normal) {
    return onThing(frame.viewerLight.xyz - at, vec3(frame.viewerLight.w), kViewerFalloff, normal);
}

// Light that is not baked, on walls of cells.
vec3 onGreyWall(vec3 light) {
#ifdef WALL_GREY
    return light * float(WALL_GREY);
#else
    return light;
#endif
}

// Light of lamps and of the viewer on the wall of a cell.
vec3 lampsOnWall(uint firstLamp, uint lampCount, vec3 at, vec3 normal) {
    return bakedLight(Incident(vec3(0.0), vec3(0.0), kLitWalls, firstLamp, lampCount), at, normal) + onGreyWall(ofViewer(at, normal));
}

// Light of a vertex with a normal of unit length or 0. `emission`: its material's luminosity.
// PIXEL_LAMPS: without lampsOnWall, which fragments add.
vec3 lightAt(Incident light, float emission, vec3 at, vec3 normal, vec3 origin) {
#ifdef BAKED_LIGHT_REPLACES
    emission = light.kind == kLitWalls ? 0.0 : emission;
#endif
#ifdef WALL_GREY
    light.ambient = light.kind == kLitWalls ? onGreyWall(light.ambient) : light.ambient;
#endif
    vec3 sum = vec3(emission) + light.ambient + light.sun * max(0.0, dot(normal, frame.sunDirection.xyz));
#if !defined(FAST) || defined(LAMPS)
    Incident walls = light;
    walls.lampCount = light.kind == kLitWalls && kLightsWalls ? light.lampCount : 0u; // loops without turns rather than branches
    Incident thing = light;
    thing.lampCount = light.kind == kLitWalls ? 0u : light.lampCount;
    sum += bakedLight(walls, at, normal) + lampLight(thing, at, normal, origin);
    if (light.kind != kLitOutdoors && (light.kind != kLitWalls || kLightsWalls)) {
#ifdef WALL_GREY
        sum += light.kind == kLitWalls ? onGreyWall(ofViewer(at, normal)) : ofViewer(at, normal);
#else
        sum += ofViewer(at, normal);
#endif
    }
#endif
#ifdef TERRAIN
    return cutToBytes(sum);
#else
    return clamp(sum, 0.0, 1.0);
#endif
}

// Share of fog, 0..1, linear between near and far.
float fogAt(vec3 eyeRelative) {
    float range = max(frame.fogRange.y - frame.fogRange.x, 1.0e-3);
    return clamp((length(eyeRelative) - frame.fogRange.x) / range, 0.0, 1.0);
}

// The same on a surface with this light: LightSet.kind.
float fogOn(uint kind, vec3 eyeRelative) {
#ifdef NO_CELL_FOG
    return kind == kLitOutdoors ? fogAt(eyeRelative) : 0.0;
#else
    return fogAt(eyeRelative);
#endif
}
