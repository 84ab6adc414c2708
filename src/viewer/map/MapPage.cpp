#include "viewer/map/MapPage.h"

#include "engine/map/MapCoordinates.h"
#include "world/World.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <numbers>

namespace limen::viewer {
namespace {

constexpr ImU32 kMapInk = IM_COL32(255, 255, 255, 255), kMapShadow = IM_COL32(0, 0, 0, 200);
constexpr ImU32 kMapLoaded = IM_COL32(255, 210, 90, 150), kMapEye = IM_COL32(255, 90, 60, 255);

ImVec2 screen(const Vec2& at) {
    return {static_cast<float>(at.x), static_cast<float>(at.y)};
}

/// Objects of a world.db that the map marks.
struct MarkKind {
    placements::TemplateType type;
    const char* label;
    ImU32 ink;
    double mostMetresPerUnit; ///< in a view of more ground they are not shown
};
constexpr double kEveryView = 1e9;
constexpr std::array<MarkKind, 3> kMarkKinds{{
    {placements::TemplateType::Portal, "portals", IM_COL32(190, 110, 255, 255), kEveryView},
    {placements::TemplateType::Lifestone, "lifestones", IM_COL32(90, 200, 255, 255), kEveryView},
    {placements::TemplateType::Door, "doors", IM_COL32(230, 170, 90, 255), 1.0},
}};

} // namespace

void MapPage::takeMap(const MapFacts& facts) {
    if (source_ != facts.source) {
        work_.reset();
        reading_.reset();
        map_.reset();
        places_.clear();
        source_ = facts.source;
        revision_ = 0;
        isFitted_ = false;
        beginMarks();
        work_ = std::make_unique<engine::MapInBackground>(source_);
    }
    takeMarks();
    if (std::shared_ptr<const engine::LandscapeMap> changed = work_->since(revision_)) {
        map_ = std::move(changed);
        texture_.write(*map_);
        places_ = engine::placesOnMap(source_->file.places, *map_);
    }
}

void MapPage::beginMarks() {
    static_assert(kMarkKinds.size() == kMarkKindCount);
    marks_ = {};
    std::vector<placements::TemplateType> types;
    for (const MarkKind& kind : kMarkKinds)
        types.push_back(kind.type);
    reading_ = std::make_unique<engine::MarksInBackground>(source_, std::move(types));
}

void MapPage::takeMarks() {
    const auto read = reading_ != nullptr ? reading_->take() : nullptr;
    if (read == nullptr)
        return;
    for (std::size_t kind = 0; kind < kMarkKindCount; ++kind)
        marks_[kind].points = (*read)[kind];
    reading_.reset();
}

MapChoice MapPage::draw(Ui& ui, const MapFacts& facts, bool isNew) {
    MapChoice choice;
    takeMap(facts);
    if (isNew) {
        search_ = {};
        note_.clear();
        isFitted_ = false;
    }
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(size);
    ImGui::SetNextWindowBgAlpha(1.0f);
    constexpr ImGuiWindowFlags kFlags =
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
        ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoBringToFrontOnFocus;
    ImGui::Begin("##map page", nullptr, kFlags);
    const float side = std::min(uiLength(230.0f), size.x * 0.34f);
    ImGui::BeginChild("##map", {ImGui::GetContentRegionAvail().x - side - uiLength(8.0f), 0.0f}, false,
                      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    drawMap(ui, facts, choice);
    ImGui::EndChild();
    ImGui::SameLine();
    ImGui::BeginChild("##side");
    drawSide(ui, source_->file.places, choice);
    ImGui::EndChild();
    ImGui::End();
    return choice;
}

void MapPage::drawMap(Ui& ui, const MapFacts& facts, MapChoice& choice) {
    const ImVec2 least = ImGui::GetCursorScreenPos();
    ImVec2 size = ImGui::GetContentRegionAvail();
    size.y = std::max(size.y - ImGui::GetTextLineHeightWithSpacing(), 1.0f);
    size.x = std::max(size.x, 1.0f);
    box_ = {static_cast<double>(least.x), static_cast<double>(least.y), static_cast<double>(size.x),
            static_cast<double>(size.y)};
    ImGui::InvisibleButton("##ground", size);
    ui.note("map");
    const bool isHovered = ImGui::IsItemHovered();
    ImDrawList* list = ImGui::GetWindowDrawList();
    const ImVec2 most{least.x + size.x, least.y + size.y};
    list->AddRectFilled(least, most, IM_COL32(10, 11, 13, 255));
    pointed_.clear();
    if (map_ == nullptr || map_->blocks.empty()) {
        const std::string failure = work_->failure();
        uiNote(!failure.empty()  ? "The map cannot be drawn: " + failure
               : work_->isDone() ? std::string("The data has no landblock.")
                                 : std::string("Reading the landscape ..."));
        return;
    }
    if (!isFitted_) {
        const Vec2 eye(facts.eye);
        const bool isOnMap = map_->find(engine::blockAtPoint(eye)) != nullptr;
        view_ = isOnMap ? aroundPoint(eye, box_) : wholeMap(*map_, box_);
        const MapView whole = wholeMap(*map_, box_);
        if (view_.metresPerUnit > whole.metresPerUnit)
            view_ = whole; // a small world fits as a whole
        isFitted_ = true;
    }
    if (isHovered || ImGui::IsItemActive())
        takeMouse(choice);
    list->PushClipRect(least, most, true);
    const Vec2 corner = view_.screenAt(box_, {map_->southWest().x, map_->northEast().y});
    const Vec2 opposite = view_.screenAt(box_, {map_->northEast().x, map_->southWest().y});
    list->AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture_.name())),
                   screen(corner), screen(opposite));
    drawObjects();
    drawPlaceNames(source_->file.places);
    drawMarks(facts); // the eye is on top
    list->PopClipRect();
    const std::string work =
        work_->isDone() ? std::string() : fmt::format("   painting {:.0f} %", work_->progress() * 100.0);
    uiText((pointed_.empty() ? "wheel: zoom   drag: move   click: go there" : pointed_) + work +
           (note_.empty() ? "" : "   " + note_));
}

void MapPage::takeMouse(MapChoice& choice) {
    constexpr double kStill = 4.0; // units; a smaller movement is a click
    const ImGuiIO& io = ImGui::GetIO();
    const Vec2 cursor(static_cast<double>(io.MousePos.x), static_cast<double>(io.MousePos.y));
    if (ImGui::IsItemActivated())
        dragged_ = 0.0;
    if (ImGui::IsItemActive()) {
        const Vec2 by(static_cast<double>(io.MouseDelta.x), static_cast<double>(io.MouseDelta.y));
        dragged_ += glm::length(by);
        if (dragged_ > kStill)
            view_ = dragged(view_, *map_, by);
    }
    if (io.MouseWheel != 0.0f)
        view_ = zoomed(view_, *map_, box_, cursor, static_cast<double>(io.MouseWheel));
    const Vec2 point = view_.pointAt(box_, cursor);
    const engine::LandscapeMap::Block* block = map_->find(engine::blockAtPoint(point));
    const bool isOnGround = block != nullptr && block->hasGround && map_->colourAt(point);
    pointed_ = fmt::format("{}   block {}{}", engine::mapText(point),
                           engine::blockText(engine::blockAtPoint(point)), isOnGround ? "" : "   no ground");
    if (ImGui::IsItemDeactivated() && dragged_ <= kStill) {
        if (isOnGround)
            choice.point = point;
        else
            note_ = "there is no ground at this point";
    }
}

void MapPage::drawMarks(const MapFacts& facts) {
    ImDrawList* list = ImGui::GetWindowDrawList();
    const auto isLoaded = [&](int x, int y) {
        return std::find(facts.loaded.begin(), facts.loaded.end(), dat::BlockCoord{x, y}) !=
               facts.loaded.end();
    };
    const auto edge = [&](int x0, int y0, int x1, int y1) {
        list->AddLine(screen(view_.screenAt(box_, Vec2(x0, y0) * world::kBlockSize)),
                      screen(view_.screenAt(box_, Vec2(x1, y1) * world::kBlockSize)), kMapLoaded, 2.0f);
    };
    for (const dat::BlockCoord& at : facts.loaded) { // the outline of the area: sides without a neighbour
        if (!isLoaded(at.x - 1, at.y))
            edge(at.x, at.y, at.x, at.y + 1);
        if (!isLoaded(at.x + 1, at.y))
            edge(at.x + 1, at.y, at.x + 1, at.y + 1);
        if (!isLoaded(at.x, at.y - 1))
            edge(at.x, at.y, at.x + 1, at.y);
        if (!isLoaded(at.x, at.y + 1))
            edge(at.x, at.y + 1, at.x + 1, at.y + 1);
    }
    const Vec2 eye = view_.screenAt(box_, Vec2(facts.eye));
    const double yaw = facts.yaw * std::numbers::pi / 180.0, size = static_cast<double>(uiLength(11.0f));
    const Vec2 ahead(std::sin(yaw), -std::cos(yaw)), right(std::cos(yaw), std::sin(yaw));
    const std::array<ImVec2, 4> arrow{screen(eye + ahead * size), screen(eye + (right - ahead) * size * 0.7),
                                      screen(eye - ahead * size * 0.3),
                                      screen(eye - (right + ahead) * size * 0.7)};
    list->AddTriangleFilled(arrow[0], arrow[1], arrow[2], kMapEye);
    list->AddTriangleFilled(arrow[0], arrow[2], arrow[3], kMapEye);
    list->AddPolyline(arrow.data(), static_cast<int>(arrow.size()), kMapShadow, ImDrawFlags_Closed, 1.5f);
}

void MapPage::drawObjects() {
    ImDrawList* list = ImGui::GetWindowDrawList();
    const float radius = uiLength(2.5f);
    for (std::size_t kind = 0; kind < kMarkKinds.size(); ++kind) {
        if (!marks_[kind].isShown || view_.metresPerUnit > kMarkKinds[kind].mostMetresPerUnit)
            continue;
        for (const Vec2& point : marks_[kind].points) {
            const Vec2 dot = view_.screenAt(box_, point);
            if (dot.x < box_.x || dot.y < box_.y || dot.x >= box_.x + box_.width ||
                dot.y >= box_.y + box_.height)
                continue;
            list->AddCircleFilled(screen(dot), radius + 1.0f, kMapShadow, 8);
            list->AddCircleFilled(screen(dot), radius, kMarkKinds[kind].ink, 8);
        }
    }
}

/// Switches for the kinds of marks that this world has.
void MapPage::drawSwitches(Ui& ui) {
    for (std::size_t kind = 0; kind < kMarkKinds.size(); ++kind) {
        if (marks_[kind].points.empty())
            continue;
        ImGui::PushStyleColor(ImGuiCol_CheckMark, kMarkKinds[kind].ink);
        ui.checkbox(kMarkKinds[kind].label, marks_[kind].isShown);
        ImGui::PopStyleColor();
    }
}

void MapPage::drawPlaceNames(std::span<const world::Place> places) {
    ImDrawList* list = ImGui::GetWindowDrawList();
    std::vector<engine::LabelBox> boxes;
    std::vector<std::size_t> named;
    const float radius = uiLength(3.0f);
    for (const engine::PlaceOnMap& at : places_) {
        const Vec2 dot = view_.screenAt(box_, at.point);
        const bool isShown =
            dot.x >= box_.x && dot.y >= box_.y && dot.x < box_.x + box_.width && dot.y < box_.y + box_.height;
        if (at.isDungeon || !isShown)
            continue;
        list->AddCircleFilled(screen(dot), radius + 1.0f, kMapShadow);
        list->AddCircleFilled(screen(dot), radius, kMapInk);
        const ImVec2 size = ImGui::CalcTextSize(places[at.place].name.c_str());
        boxes.push_back({dot.x + static_cast<double>(radius * 2.0f), dot.y - static_cast<double>(size.y) / 2,
                         static_cast<double>(size.x), static_cast<double>(size.y)});
        named.push_back(at.place);
    }
    for (const std::size_t i : engine::labelsWithoutOverlap(boxes))
        uiOutlined(*list, static_cast<float>(boxes[i].x), static_cast<float>(boxes[i].y),
                   places[named[i]].name.c_str());
}

void MapPage::drawSide(Ui& ui, std::span<const world::Place> places, MapChoice& choice) {
    ImGui::SetNextItemWidth(-1.0f);
    ImGui::InputTextWithHint("##search", "search places", search_.data(), search_.size());
    ui.note("search");
    drawSwitches(ui);
    const ImGuiStyle& style = ImGui::GetStyle();
    const float texts = ImGui::CalcTextSize("Whole map").x + ImGui::CalcTextSize("Back").x;
    const bool fitInOneRow =
        texts + 4.0f * style.FramePadding.x + style.ItemSpacing.x <= ImGui::GetContentRegionAvail().x;
    const float footer = ImGui::GetFrameHeightWithSpacing() * (fitInOneRow ? 1.0f : 2.0f);
    ImGui::BeginChild("##lists", {0.0f, -footer});
    drawList(ui, "Places", places, false, choice);
    drawList(ui, "Dungeons", places, true, choice);
    ImGui::EndChild();
    if (ui.button("Whole map", fitInOneRow ? 0.0f : -1.0f) && map_ != nullptr)
        view_ = wholeMap(*map_, box_);
    if (fitInOneRow)
        ImGui::SameLine();
    choice.isBack = ui.button("Back", -1.0f);
}

void MapPage::drawList(Ui& ui, const char* heading, std::span<const world::Place> places, bool ofDungeons,
                       MapChoice& choice) {
    const std::string wanted(search_.data());
    bool hasHeading = false;
    for (const engine::PlaceOnMap& at : places_) {
        const std::string& name = places[at.place].name;
        if (at.isDungeon != ofDungeons || !engine::matchesName(name, wanted))
            continue;
        if (!std::exchange(hasHeading, true))
            uiHeading(heading);
        ImGui::PushID(static_cast<int>(at.place));
        if (ui.selectable(name.c_str()))
            choice.place = at.place;
        ImGui::PopID();
    }
}

} // namespace limen::viewer
