#include "visibility/View.h"

#include <cmath>
#include <numbers>

namespace limen::visibility {

Mat3 View::screenFromEye() const {
    return glm::transpose(Mat3(right / tanHalfX, up / tanHalfY, forward));
}

Result<View> viewOf(const LookAt& look) {
    const auto refuse = [](const char* why) { return fail(ErrorCode::BadArgument, "view", why); };
    if (!isFinite(look.eye) || !isFinite(look.target) || !isFinite(look.up))
        return refuse("eye, target and up must be finite");
    if (!(look.heightDegrees > 0.0 && look.heightDegrees < 180.0))
        return refuse("the field of view must be more than 0 and less than 180 degrees");
    if (!(look.aspect > 0.0 && std::isfinite(look.aspect)))
        return refuse("the aspect must be positive and finite");
    const Vec3 gaze = look.target - look.eye, side = glm::cross(gaze, look.up);
    if (!(glm::length(gaze) > 0.0))
        return refuse("the target is in the eye");
    if (!(glm::length(side) > 1e-9 * glm::length(gaze) * glm::length(look.up)))
        return refuse("up is along the gaze");
    View view;
    view.eye = look.eye;
    view.forward = glm::normalize(gaze);
    view.right = glm::normalize(side);
    view.up = glm::cross(view.right, view.forward);
    view.tanHalfY = std::tan(look.heightDegrees * std::numbers::pi / 360.0);
    view.tanHalfX = view.tanHalfY * look.aspect;
    view.root = look.root;
    return view;
}

} // namespace limen::visibility
