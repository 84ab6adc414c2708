#include "visibility/View.h"

namespace limen::visibility {

Mat3 View::screenFromEye() const {
    return glm::transpose(Mat3(right / tanHalfX, up / tanHalfY, forward));
}

} // namespace limen::visibility
