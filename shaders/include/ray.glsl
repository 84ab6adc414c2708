// Through a point of the window, eye-relative, where the view depth is one metre.
vec3 rayThrough(vec2 window) {
    return frame.rayCorner.xyz + frame.rayRight.xyz * window.x + frame.rayUp.xyz * window.y;
}
