#include "output/report/CheckRecorder.h"

#include "check/Report.h"
#include "engine/CheckView.h"
#include "output/CheckPicture.h"
#include "output/Encode.h"

#include <algorithm>

namespace limen::output {
namespace {

constexpr std::size_t kMostFindings = 60, kSamplesOfKind = 2;
constexpr std::uint32_t kLitWidth = 640; ///< pixels

CheckedView describedView(const check::View& view, std::uint64_t number, const std::string& worldOptions) {
    CheckedView checked;
    checked.number = number;
    checked.kind = check::nameOf(view.kind);
    checked.about = view.about;
    checked.command = check::shotCommand(view, worldOptions);
    return checked;
}

Result<ReportPicture> encoded(const char* caption, const Picture& picture, PictureFormat format) {
    Result<std::vector<std::byte>> bytes = encodePicture(picture, format);
    if (!bytes)
        return Failure(bytes.error());
    return ReportPicture{caption, std::string(mediaTypeOf(format)), std::move(*bytes), picture.width,
                         picture.height};
}

} // namespace

Result<CheckRecorder::Kept> CheckRecorder::keep(const check::FindingPicture& view) const {
    Kept kept{view.view, describedView(view.view, view.number, worldOptions_)};
    kept.data.counts = view.comparison.counts;
    const FindingPanels panels = panelsOfFinding(view);
    const bool isFlat = !view.drawn.samples.empty();
    for (const auto& [caption, picture] :
         {std::pair(isFlat ? "Drawn: a colour for each id, with the visits outlined"
                           : "Drawn: ids, with the visits outlined",
                    &panels.drawn),
          {"Traced: ids by the ray rule", &panels.traced},
          {"Difference: the verdict on each pixel", &panels.verdicts}}) {
        Result<ReportPicture> bytes = encoded(caption, *picture, PictureFormat::Png);
        if (!bytes)
            return Failure(bytes.error());
        kept.data.pictures.push_back(std::move(*bytes));
    }
    return kept;
}

Result<void> CheckRecorder::addFinding(const check::FindingPicture& view) {
    if (findings_.size() >= kMostFindings)
        return {};
    Result<Kept> kept = keep(view);
    if (!kept)
        return Failure(kept.error());
    findings_.push_back(std::move(*kept));
    return {};
}

Result<void> CheckRecorder::addSample(const check::FindingPicture& view) {
    const auto ofKind = std::count_if(samples_.begin(), samples_.end(),
                                      [&](const Kept& kept) { return kept.view.kind == view.view.kind; });
    if (static_cast<std::size_t>(ofKind) >= kSamplesOfKind)
        return {};
    Result<Kept> kept = keep(view);
    if (!kept)
        return Failure(kept.error());
    samples_.push_back(std::move(*kept));
    return {};
}

Result<void> CheckRecorder::addLitPictures(engine::Session& session) {
    for (std::vector<Kept>* list : {&findings_, &samples_})
        for (Kept& kept : *list) {
            if (Result<void> loaded = session.load(check::centreOf(kept.view)); !loaded)
                return loaded;
            const world::SpaceIndex root = engine::rootIn(session.part(), kept.view.root, kept.view.eye);
            const engine::FrameRequest request = engine::requestOf(kept.view, session.part().world, root);
            if (Result<void> drawn = session.draw(request, {.ids = false}); !drawn)
                return drawn;
            const Picture lit =
                pictureFromRgba(request.size.width, request.size.height, session.target().readColour());
            Result<ReportPicture> picture = encoded(
                "Drawn: as the window shows it", shrunkToFit(lit, kLitWidth, kLitWidth), PictureFormat::Webp);
            if (!picture)
                return Failure(picture.error());
            kept.data.pictures.insert(kept.data.pictures.begin(), std::move(*picture));
        }
    return {};
}

CheckReport CheckRecorder::finish(ReportHead head, const check::Totals& totals) && {
    CheckReport report{std::move(head), totals, {}, {}};
    for (Kept& kept : samples_)
        report.samples.push_back(std::move(kept.data));
    for (Kept& kept : findings_) {
        for (const check::Finding& worst : totals.worst)
            if (worst.number == kept.data.number)
                kept.data.moved = worst.moved;
        report.findings.push_back(std::move(kept.data));
    }
    for (const check::Finding& worst : totals.worst) {
        const bool isKept = std::any_of(report.findings.begin(), report.findings.end(),
                                        [&](const CheckedView& view) { return view.number == worst.number; });
        if (isKept)
            continue;
        CheckedView view = describedView(worst.view, worst.number, worldOptions_);
        view.counts = worst.counts;
        view.moved = worst.moved;
        report.findings.push_back(std::move(view));
    }
    const auto wrong = [](const CheckedView& view) {
        std::uint64_t sum = view.moved;
        for (std::size_t i = 0; i < check::kVerdictCount; ++i)
            sum += check::isFinding(static_cast<check::Verdict>(i)) ? view.counts[i] : 0;
        return sum;
    };
    std::stable_sort(report.findings.begin(), report.findings.end(),
                     [&](const CheckedView& a, const CheckedView& b) { return wrong(a) > wrong(b); });
    return report;
}

} // namespace limen::output
