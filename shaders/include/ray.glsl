// Direction of the ray through a point of the window, eye-relative, of view depth one metre.
vec3 rayThrough(vec2 window) {
    return frame.rayCorner.xyz + frame.rayRight.xyz * window.x + frame.rayUp.xyz * window.y;
}
