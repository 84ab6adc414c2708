#include "output/Gltf.h"

#include "output/Encode.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <sstream>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>
#pragma GCC diagnostic pop

namespace limen::output {
namespace {

/// Builds the glTF model and its single buffer, instance by instance.
class Writer {
public:
    explicit Writer(const world::World& world) : world_(world) {
        model_.asset.version = "2.0";
        model_.asset.generator = "limen";
        model_.buffers.emplace_back();
        tinygltf::Node root;
        // A quaternion: -90 degrees about x turns z up into y up.
        root.rotation = {-std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)};
        model_.nodes.push_back(root);
        tinygltf::Scene scene;
        scene.nodes = {0};
        model_.scenes.push_back(scene);
        model_.defaultScene = 0;
    }

    Result<void> add(const world::Instance& instance, const Vec3& origin) {
        const Result<int> mesh = meshOf(instance);
        if (!mesh)
            return Failure(mesh.error());
        if (*mesh < 0)
            return {};
        tinygltf::Node node;
        node.name = dat::idText(instance.record);
        node.mesh = *mesh;
        const Vec3 at = world_.blocks[instance.block].origin() - origin + Vec3(instance.origin);
        for (int column = 0; column < 3; ++column) {
            for (int row = 0; row < 3; ++row)
                node.matrix.push_back(static_cast<double>(instance.linear[column][row]));
            node.matrix.push_back(0.0);
        }
        node.matrix.insert(node.matrix.end(), {at.x, at.y, at.z, 1.0});
        model_.nodes.front().children.push_back(static_cast<int>(model_.nodes.size()));
        model_.nodes.push_back(node);
        return {};
    }

    [[nodiscard]] bool empty() const { return model_.nodes.size() < 2; }

    [[nodiscard]] std::string bytes() {
        std::ostringstream out;
        tinygltf::TinyGLTF gltf;
        gltf.WriteGltfSceneToStream(&model_, out, false, true);
        return out.str();
    }

private:
    template <class T>
    int addView(std::span<const T> values, int target) {
        std::vector<unsigned char>& data = model_.buffers.front().data;
        data.resize((data.size() + 3) / 4 * 4); // glTF 2.0: float accessors are aligned to 4 bytes
        tinygltf::BufferView view;
        view.buffer = 0;
        view.byteOffset = data.size();
        view.byteLength = values.size_bytes();
        view.target = target;
        const auto* first = reinterpret_cast<const unsigned char*>(values.data());
        data.insert(data.end(), first, first + values.size_bytes());
        model_.bufferViews.push_back(view);
        return static_cast<int>(model_.bufferViews.size() - 1);
    }

    template <class T>
    int addAccessor(std::span<const T> values, int components) {
        tinygltf::Accessor accessor;
        accessor.bufferView = addView(values, TINYGLTF_TARGET_ARRAY_BUFFER);
        accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
        accessor.count = values.size();
        accessor.type = components;
        model_.accessors.push_back(accessor);
        return static_cast<int>(model_.accessors.size() - 1);
    }

    Result<int> textureOf(std::uint32_t index, bool clamp) {
        const auto [entry, fresh] = textures_.try_emplace({index, clamp}, -1);
        if (!fresh)
            return entry->second;
        const world::Image& picture = *world_.textures[index];
        const auto png = encodePng(picture.width, picture.height, picture.rgba);
        if (!png)
            return Failure(png.error());
        tinygltf::Image image;
        image.mimeType = "image/png";
        image.bufferView = addView(std::span<const std::byte>(*png), 0);
        model_.images.push_back(image);
        tinygltf::Sampler sampler;
        sampler.magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
        sampler.minFilter = TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
        sampler.wrapS = sampler.wrapT =
            clamp ? TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE : TINYGLTF_TEXTURE_WRAP_REPEAT;
        model_.samplers.push_back(sampler);
        tinygltf::Texture texture;
        texture.source = static_cast<int>(model_.images.size() - 1);
        texture.sampler = static_cast<int>(model_.samplers.size() - 1);
        model_.textures.push_back(texture);
        return entry->second = static_cast<int>(model_.textures.size() - 1);
    }

    Result<int> materialOf(std::uint32_t index) {
        const auto [entry, fresh] = materials_.try_emplace(index, -1);
        if (!fresh)
            return entry->second;
        const world::Material& in = world_.materials[index];
        tinygltf::Material out;
        out.name = dat::idText(in.surface);
        tinygltf::PbrMetallicRoughness& look = out.pbrMetallicRoughness;
        look.metallicFactor = 0.0;
        look.roughnessFactor = 1.0;
        look.baseColorFactor = {in.colour.x, in.colour.y, in.colour.z, in.colour.w};
        if (in.texture != world::kNone) {
            const Result<int> texture = textureOf(in.texture, (in.flags & world::Material::kClamp) != 0);
            if (!texture)
                return Failure(texture.error());
            look.baseColorTexture.index = *texture;
            if (in.luminosity > 0.0f)
                out.emissiveTexture.index = *texture;
        }
        out.emissiveFactor = {in.colour.x * in.luminosity, in.colour.y * in.luminosity,
                              in.colour.z * in.luminosity};
        if (in.surfaceClass == world::SurfaceClass::CutOut)
            out.alphaMode = "MASK"; // the default threshold is 0.5
        if (in.surfaceClass == world::SurfaceClass::Blended)
            out.alphaMode = "BLEND";
        model_.materials.push_back(out);
        return entry->second = static_cast<int>(model_.materials.size() - 1);
    }

    /// Triangles of one surface.
    struct Triangles {
        std::vector<Vec3f> positions, normals;
        std::vector<Vec2f> uvs;
    };
    [[nodiscard]] std::map<std::uint16_t, Triangles> trianglesOf(const world::Mesh& mesh) const {
        std::map<std::uint16_t, Triangles> bySlot;
        for (const world::Mesh::Range& range : mesh.ranges) {
            for (std::uint32_t i = range.firstIndex; i < range.firstIndex + range.indexCount; ++i) {
                const world::MeshVertex& vertex = world_.vertices[mesh.firstVertex + world_.indices[i]];
                Triangles& triangles = bySlot[vertex.surface];
                triangles.positions.push_back(vertex.position);
                const float length = glm::length(vertex.normal);
                triangles.normals.push_back(length > 0.0f ? vertex.normal / length : Vec3f(0.0f, 0.0f, 1.0f));
                triangles.uvs.push_back(vertex.uv);
            }
        }
        return bySlot;
    }

    /// The index of the instance's mesh in the model; -1: the mesh has no triangles.
    Result<int> meshOf(const world::Instance& instance) {
        const auto [entry, fresh] = meshes_.try_emplace({instance.mesh, instance.firstMaterial}, -1);
        if (!fresh)
            return entry->second;
        tinygltf::Mesh mesh;
        for (const auto& [slot, triangles] : trianglesOf(world_.meshes[instance.mesh])) {
            const Result<int> material = materialOf(world_.materialRefs[instance.firstMaterial + slot]);
            if (!material)
                return Failure(material.error());
            tinygltf::Primitive primitive;
            primitive.mode = TINYGLTF_MODE_TRIANGLES;
            primitive.material = *material;
            const int positions =
                addAccessor(std::span<const Vec3f>(triangles.positions), TINYGLTF_TYPE_VEC3);
            Vec3f low(triangles.positions.front()), high(low);
            for (const Vec3f& p : triangles.positions) {
                low = glm::min(low, p);
                high = glm::max(high, p);
            }
            model_.accessors.back().minValues = {low.x, low.y, low.z};
            model_.accessors.back().maxValues = {high.x, high.y, high.z};
            primitive.attributes["POSITION"] = positions;
            primitive.attributes["NORMAL"] =
                addAccessor(std::span<const Vec3f>(triangles.normals), TINYGLTF_TYPE_VEC3);
            primitive.attributes["TEXCOORD_0"] =
                addAccessor(std::span<const Vec2f>(triangles.uvs), TINYGLTF_TYPE_VEC2);
            mesh.primitives.push_back(primitive);
        }
        if (mesh.primitives.empty())
            return -1;
        mesh.name = dat::idText(instance.record);
        model_.meshes.push_back(mesh);
        return entry->second = static_cast<int>(model_.meshes.size() - 1);
    }

    const world::World& world_;
    tinygltf::Model model_;
    std::map<std::pair<std::uint32_t, bool>, int> textures_;
    std::map<std::uint32_t, int> materials_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> meshes_;
};

} // namespace

Result<std::string> encodeGlb(const world::World& world, std::span<const world::InstanceIndex> instances,
                              const Vec3& origin) {
    Writer writer(world);
    for (const world::InstanceIndex index : instances) {
        const world::Instance& instance = world.instances[index];
        if (instance.kind == world::InstanceKind::Terrain)
            continue;
        if (Result<void> added = writer.add(instance, origin); !added)
            return Failure(added.error());
    }
    if (writer.empty())
        return fail(ErrorCode::NotFound, "glTF",
                    "no mesh among these instances; select objects other than terrain");
    return writer.bytes();
}

} // namespace limen::output
