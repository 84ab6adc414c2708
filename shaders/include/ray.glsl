// Through a point of the window, eye-relative, where the view depth is one metre.
vec3 rayThrough(vec2 window) {
    return device.rayCorner.xyz + device.rayRight.xyz * window.x + device.rayUp.xyz * window.y;
}
