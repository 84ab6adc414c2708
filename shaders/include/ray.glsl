// Direction of the ray through a point of the window, eye-relative, of view depth one metre.
vec3 rayThrough(vec2 window) {
    return device.rayCorner.xyz + device.rayRight.xyz * window.x + device.rayUp.xyz * window.y;
}
