#include "worlds/builtin/land/PlantPictures.h"

#include "core/Assert.h"

#include <limits>

namespace limen::worlds {

namespace {

constexpr int kReduction = 4; ///< of the pictures of materials
constexpr int kSamples = 4;   ///< samples of a texel along each axis
/// Alpha of an empty texel. Alpha 1/2 then means that a third is covered, at every mip level: thin branches and trunks
/// stay when a texel becomes larger than they are.
constexpr float kEmptyAlpha = 0.1f;
constexpr double kDownwards =
    0.15; ///< slope of the view: an eye is more often above a plant's foot than below
constexpr double kBorder =
    2.0; ///< empty texels at each edge of a field, so that mip levels do not mix fields

/// A grid of samples that keeps the nearest.
class Samples {
public:
    explicit Samples(int size)
        : size_(size), colours_(static_cast<std::size_t>(size * size), Vec4f(0.0f)),
          depths_(static_cast<std::size_t>(size * size), std::numeric_limits<double>::infinity()) {}

    [[nodiscard]] int size() const { return size_; }
    [[nodiscard]] const Vec4f& at(int x, int y) const { return colours_[index(x, y)]; }
    void put(int x, int y, double depth, const Vec4f& colour) {
        if (depth >= depths_[index(x, y)])
            return;
        depths_[index(x, y)] = depth;
        colours_[index(x, y)] = colour;
    }

private:
    [[nodiscard]] std::size_t index(int x, int y) const { return static_cast<std::size_t>(y * size_ + x); }

    int size_;
    std::vector<Vec4f> colours_;
    std::vector<double> depths_;
};

/// A corner on the grid: x right and y down in samples, the depth, and its place in the material's picture.
struct Corner {
    Vec2 at{0.0};
    double depth = 0.0;
    Vec2 uv{0.0};
};

double cross(const Vec2& a, const Vec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// The picture at a mip level about as fine as a field. Far away, a cut-out is filtered before it is tested, and looks
/// fuller than its finest texels.
Canvas reduced(const Canvas& picture) {
    const int width = std::max(1, picture.width() / kReduction),
              height = std::max(1, picture.height() / kReduction);
    Canvas out(width, height);
    const int across = picture.width() / width, down = picture.height() / height;
    for (int i = 0; i < width * height; ++i) {
        Vec4f sum(0.0f);
        for (int k = 0; k < across * down; ++k) {
            const Vec4f& texel = picture.at(i % width * across + k % across, i / width * down + k / across);
            sum += Vec4f(Vec3f(texel) * texel.w, texel.w);
        }
        out.at(i % width, i / width) =
            sum.w > 0.0f ? Vec4f(Vec3f(sum) / sum.w, sum.w / static_cast<float>(across * down)) : Vec4f(0.0f);
    }
    return out;
}

/// Bilinear, of the picture repeated. Colours are weighted by alpha.
Vec4f texelAt(const Canvas& picture, const Vec2& uv) {
    const Vec2 at = uv * Vec2(picture.width(), picture.height()) - 0.5;
    const Vec2 low = glm::floor(at);
    const Vec2 share = at - low;
    Vec4f sum(0.0f);
    for (int k = 0; k < 4; ++k) {
        const int x = static_cast<int>(low.x) + k % 2, y = static_cast<int>(low.y) + k / 2;
        const auto wrapped = [](int i, int size) { return ((i % size) + size) % size; };
        const Vec4f& texel = picture.at(wrapped(x, picture.width()), wrapped(y, picture.height()));
        const double weight = (k % 2 == 0 ? 1.0 - share.x : share.x) * (k / 2 == 0 ? 1.0 - share.y : share.y);
        sum += Vec4f(Vec3f(texel) * texel.w, texel.w) * static_cast<float>(weight);
    }
    return sum.w > 0.0f ? Vec4f(Vec3f(sum) / sum.w, sum.w) : Vec4f(0.0f);
}

void drawTriangle(Samples& samples, const std::array<Corner, 3>& t, const Canvas& picture) {
    const double area = cross(t[1].at - t[0].at, t[2].at - t[0].at);
    if (std::abs(area) < 1e-9)
        return;
    const Vec2 least = glm::min(glm::min(t[0].at, t[1].at), t[2].at);
    const Vec2 most = glm::max(glm::max(t[0].at, t[1].at), t[2].at);
    const int last = samples.size() - 1;
    for (int y = std::max(0, static_cast<int>(least.y)); y <= std::min(last, static_cast<int>(most.y)); ++y) {
        for (int x = std::max(0, static_cast<int>(least.x)); x <= std::min(last, static_cast<int>(most.x));
             ++x) {
            const Vec2 p(x + 0.5, y + 0.5);
            const double b = cross(p - t[0].at, t[2].at - t[0].at) / area;
            const double c = cross(t[1].at - t[0].at, p - t[0].at) / area;
            if (std::min({b, c, 1.0 - b - c}) < 0.0)
                continue;
            const Vec4f texel = texelAt(picture, (1.0 - b - c) * t[0].uv + b * t[1].uv + c * t[2].uv);
            if (texel.w >= 0.5f)
                samples.put(x, y, (1.0 - b - c) * t[0].depth + b * t[1].depth + c * t[2].depth, texel);
        }
    }
}

/// The mean of a texel's samples; alpha is the share that is covered.
Vec4f meanOf(const Samples& samples, int x, int y) {
    Vec4f sum(0.0f);
    for (int k = 0; k < kSamples * kSamples; ++k) {
        const Vec4f& s = samples.at(x * kSamples + k % kSamples, y * kSamples + k / kSamples);
        if (s.w > 0.0f)
            sum += Vec4f(Vec3f(s), 1.0f);
    }
    return sum.w > 0.0f ? Vec4f(Vec3f(sum) / sum.w, sum.w / (kSamples * kSamples)) : Vec4f(0.0f);
}

Vec3 rightOf(const PlantPictures::Card& card) {
    return glm::cross(-card.facing, Vec3(0, 0, 1));
}

/// Metres to the right and up from the origin, on the plane through it that looks along `facing`: the place where an eye
/// far away sees a point.
Vec2 onCard(const PlantPictures::Card& card, const Vec3& p) {
    return {glm::dot(p, rightOf(card)), p.z - kDownwards * glm::dot(p, card.facing)};
}

/// The card that contains the mesh, with an empty border.
PlantPictures::Card cardAround(const FaceMesh& mesh, double turn, int field) {
    PlantPictures::Card card;
    card.facing = {std::sin(turn), -std::cos(turn), 0.0};
    Vec2 least(std::numeric_limits<double>::max()), most(std::numeric_limits<double>::lowest());
    for (const Face& face : mesh.faces()) {
        for (const Vec3& p : face.points) {
            least = glm::min(least, onCard(card, p));
            most = glm::max(most, onCard(card, p));
        }
    }
    const Vec2 middle = 0.5 * (least + most);
    const Vec2 half = 0.5 * (most - least) * (field / (field - 2.0 * kBorder));
    card.axis = rightOf(card) * middle.x + Vec3(0, 0, middle.y - half.y);
    card.halfWidth = half.x;
    card.height = 2.0 * half.y;
    return card;
}

} // namespace

PlantPictures::PlantPictures(PictureOf pictureOf, int field)
    : paint_(std::move(pictureOf)), field_(field), canvas_(kColumns * field, kRows * field) {
    LIMEN_ASSERT(field >= 4.0 * kBorder, "a field is larger than its border");
}

const Canvas& PlantPictures::pictureOf(Material material) {
    for (const auto& [known, canvas] : painted_)
        if (known == material)
            return canvas;
    return painted_.emplace_back(material, reduced(paint_(material))).second;
}

PlantPictures::Card PlantPictures::draw(const FaceMesh& mesh, double turn, int column, int row) {
    LIMEN_ASSERT(column >= 0 && column < kColumns && row >= 0 && row < kRows, "a field of the picture");
    Card card = cardAround(mesh, turn, field_);
    card.column = column;
    card.row = row;
    Samples samples(field_ * kSamples);
    const Vec2 corner = onCard(card, card.axis) - Vec2(card.halfWidth, 0.0);
    const auto cornerOf = [&](const Face& face, std::size_t k) {
        const Vec2 share = (onCard(card, face.points[k]) - corner) / Vec2(2.0 * card.halfWidth, card.height);
        return Corner{Vec2(share.x, 1.0 - share.y) * static_cast<double>(samples.size()),
                      -glm::dot(face.points[k], card.facing), face.uvs[k]};
    };
    for (const Face& face : mesh.faces())
        for (std::size_t k = 2; k < face.points.size(); ++k)
            drawTriangle(samples, {cornerOf(face, 0), cornerOf(face, k - 1), cornerOf(face, k)},
                         pictureOf(face.material));
    Vec4f sum(0.0f);
    for (int y = 0; y < field_; ++y) {
        for (int x = 0; x < field_; ++x) {
            const Vec4f texel = meanOf(samples, x, y);
            canvas_.at(column * field_ + x, row * field_ + y) =
                Vec4f(Vec3f(texel), kEmptyAlpha + (1.0f - kEmptyAlpha) * texel.w);
            sum += Vec4f(Vec3f(texel) * texel.w, texel.w);
        }
    }
    fillEmpty(column, row, Vec3f(sum) / std::max(sum.w, 1.0f));
    return card;
}

void PlantPictures::fillEmpty(int column, int row, const Vec3f& colour) {
    for (int y = row * field_; y < (row + 1) * field_; ++y)
        for (int x = column * field_; x < (column + 1) * field_; ++x)
            if (canvas_.at(x, y).w <= kEmptyAlpha)
                canvas_.at(x, y) = Vec4f(colour, kEmptyAlpha);
}

Face faceOf(const PlantPictures::Card& card) {
    const Vec3 right = rightOf(card) * card.halfWidth;
    const Vec3 up(0.0, 0.0, card.height);
    const double u0 = static_cast<double>(card.column) / PlantPictures::kColumns;
    const double u1 = static_cast<double>(card.column + 1) / PlantPictures::kColumns;
    const double v0 = static_cast<double>(card.row) / PlantPictures::kRows;
    const double v1 = static_cast<double>(card.row + 1) / PlantPictures::kRows;
    Face face;
    face.points = {card.axis - right, card.axis + right, card.axis + right + up, card.axis - right + up};
    face.uvs = {{u0, v1}, {u1, v1}, {u1, v0}, {u0, v0}};
    face.material = Material::FarPlants;
    return face;
}

} // namespace limen::worlds
