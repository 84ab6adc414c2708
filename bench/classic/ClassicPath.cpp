#include "ClassicPath.h"

#include "core/Assert.h"
#include "frame/PackInstance.h"

#include <cstring>

namespace limen::bench {

namespace {

namespace layout = frame::gpu;

constexpr std::size_t kBytesPerTexel = 16;
/// Bindings that each group binds again: the uniform block of the frame's constants, by one call.
constexpr std::size_t kGroupRanges = layout::kBindFrame + 1;

/// A copy with only the data that the frame's constants and the plain sky depend on.
world::World withoutContent(const world::World& world) {
    world::World bare;
    bare.blocks = world.blocks;
    bare.sky.desc = world.sky.desc;
    bare.sky.time = world.sky.time;
    bare.spaces = {world.spaces[world::kOutside]};
    bare.spaces.front().firstInstance = bare.spaces.front().instanceCount = 0;
    bare.zones = {world.zones[world::kOutsideZone]};
    bare.zoneSpaces = {world::kOutside};
    bare.lightSets = world.lightSets;
    return bare;
}

std::uint32_t texelAt(std::size_t offset) {
    return static_cast<std::uint32_t>(offset / kBytesPerTexel);
}

} // namespace

Result<std::unique_ptr<ClassicPath>> ClassicPath::create(gpu::Device& device, const world::World& world,
                                                         const world::DynamicState& dynamics) {
    LIMEN_ASSERT(world.spaces.size() == 1, "the classic path draws worlds without cells");
    Result<std::unique_ptr<ClassicScene>> scene = ClassicScene::create(device, world, dynamics);
    if (!scene)
        return Failure(scene.error());
    std::unique_ptr<ClassicPath> path(new ClassicPath(device, world, std::move(*scene)));
    path->layOut(dynamics);
    return path;
}

ClassicPath::ClassicPath(gpu::Device& device, const world::World& world, std::unique_ptr<ClassicScene> scene)
    : device_(device), world_(world), scene_(std::move(scene)), bare_(withoutContent(world)),
      bareScene_(bare_), planner_(bareScene_), storage_(scene_->storage()), textures_(scene_->textures()) {}

void ClassicPath::layOut(const world::DynamicState& dynamics) {
    const std::size_t alignment = std::max(device_.capabilities().storageAlignment, kBytesPerTexel);
    const auto place = [&](std::size_t bytes) {
        const std::size_t offset = (places_.size + alignment - 1) / alignment * alignment;
        places_.size = offset + bytes;
        return offset;
    };
    places_.constants = place(sizeof(layout::FrameConstants));
    places_.blocks = place(world_.blocks.size() * sizeof(layout::vec4));
    places_.visit = place(sizeof(layout::Visit));
    places_.members = place(dynamics.members.size() * sizeof(layout::Member));
    places_.instances =
        place((scene_->standing().size() + scene_->moving().size()) * sizeof(layout::Instance));
    places_.commands = place(scene_->groups().size() * sizeof(layout::DrawCommand));
    storage_[layout::kBindFrame] = {gpu::BufferHandle::Invalid, places_.constants,
                                    sizeof(layout::FrameConstants)};
    zones_.reserve(dynamics.members.size());
}

template <class T>
void ClassicPath::write(std::size_t offset, std::span<const T> values) {
    if (!values.empty())
        std::memcpy(memory_.data() + offset, values.data(), values.size_bytes());
}

Result<void> ClassicPath::render(const frame::FrameView& view, const world::DynamicState& dynamics,
                                 const visibility::VisibleSet& visible, gpu::RenderTarget& target) {
    LIMEN_ASSERT(visible.visits.size() == 1, "the only visit is the outside");
    LIMEN_ASSERT(dynamics.instances.size() == scene_->moving().size(),
                 "the number of dynamic instances does not change");
    planner_.plan(view, visible, base_);
    if (Result<void> reserved = device_.reserveRing(places_.size); !reserved)
        return reserved;
    begin(target);
    counts_ = {};
    zones_.clear();
    eye_ = world::rangeStepsOf(view.view.eye);
    drawGroups(FrustumSides::of(view.view), dynamics);
    device_.setState({.program = scene_->program(frame::Program::SkyPlain)});
    device_.drawVertices(0, 3);
    return device_.endFrame();
}

void ClassicPath::begin(gpu::RenderTarget& target) {
    device_.setGeometry(scene_->vertices(), scene_->indices());
    memory_ = device_.beginFrame(target.handle(), target.viewport());
    layout::FrameConstants constants;
    constants.view = base_.constants;
    constants.view.staticInstances = 0; // all instances are in the frame's memory
    constants.view.staticMembers = scene_->staticMembers();
    target.place(constants.view, constants.device);
    constants.device.firstBlock = texelAt(places_.blocks);
    constants.device.firstVisit = texelAt(places_.visit);
    constants.device.firstInstance = texelAt(places_.instances);
    constants.device.firstMember = texelAt(places_.members);
    write(places_.constants, std::span<const layout::FrameConstants>(&constants, 1));
    write(places_.blocks, std::span<const layout::vec4>(base_.blocks));
    write(places_.visit, std::span<const layout::Visit>(base_.visits));
    textures_.back() = scene_->groups().front().page;
    device_.bindStorage(storage_);
    device_.bindTextures(textures_, false);
    device_.clear(gpu::TargetImage::Ownership, gpu::rootOwner(base_.constants.rootZone));
    device_.clear(gpu::TargetImage::Colour, constants.view.voidColour);
    device_.clear(gpu::TargetImage::Id, std::uint32_t{layout::kVoidId});
    device_.clear(gpu::TargetImage::Depth, 0.0f);
    device_.beginPass(gpu::Pass::Solid);
}

void ClassicPath::drawGroups(const FrustumSides& sides, const world::DynamicState& dynamics) {
    for (const ClassicGroup& group : scene_->groups()) {
        const std::size_t known = zones_.size();
        if (const std::uint32_t count = gather(group, sides, dynamics); count > 0) {
            // A driver can start a draw at once, so the memory that it reads is written before.
            write(places_.members + known * sizeof(layout::Member),
                  std::span<const layout::Member>(zones_).subspan(known));
            drawGroup(group, count);
        }
    }
}

std::uint32_t ClassicPath::gather(const ClassicGroup& group, const FrustumSides& sides,
                                  const world::DynamicState& dynamics) {
    std::byte* const begin =
        memory_.data() + places_.instances + std::size_t{counts_.objects} * sizeof(layout::Instance);
    std::byte* to = begin;
    const auto copy = [&to](const layout::Instance& packed) {
        std::memcpy(to, &packed, sizeof packed);
        to += sizeof packed;
    };
    for (const ClassicObject& object : scene_->standing().subspan(group.firstStanding, group.standingCount))
        if (sides.sees(object.bounds) && (!object.hasLevels || isInRange(world_.instances[object.instance])))
            copy(object.packed);
    for (const std::uint32_t index : scene_->moving().subspan(group.firstMoving, group.movingCount)) {
        const world::Instance& instance = dynamics.instances[index];
        if (sides.sees(instance.bounds) && isInRange(instance)) {
            const auto spaces =
                std::span(dynamics.members).subspan(instance.firstMember, instance.memberCount);
            copy(frame::packInstance(instance,
                                     frame::packMembers(world_, spaces, {zones_, scene_->staticMembers()})));
        }
    }
    return static_cast<std::uint32_t>(static_cast<std::size_t>(to - begin) / sizeof(layout::Instance));
}

void ClassicPath::drawGroup(const ClassicGroup& group, std::uint32_t count) {
    const layout::DrawCommand command{group.indexCount, count, group.firstIndex, 0, counts_.objects};
    const std::size_t offset = places_.commands + std::size_t{counts_.draws} * sizeof command;
    write(offset, std::span<const layout::DrawCommand>(&command, 1));
    textures_.back() = group.page;
    device_.setState({.program = scene_->program(group.program)});
    device_.bindTextures(textures_, false);
    device_.bindStorage(std::span<const gpu::StorageRange>(storage_).first(kGroupRanges));
    device_.drawIndirect(offset, 1);
    counts_.objects += count;
    ++counts_.draws;
}

} // namespace limen::bench
