#pragma once

#include "check/Run.h"
#include "engine/Session.h"
#include "output/report/CheckReport.h"

namespace limen::output {

/// Collects the pictures of a CheckReport during a run. Keeps at most 60 views with findings, and the first
/// two views without a finding of each kind.
class CheckRecorder {
public:
    /// `worldOptions`: options of `limen shot` that load the same world, as in check::ReportContext.
    explicit CheckRecorder(std::string worldOptions) : worldOptions_(std::move(worldOptions)) {}

    /// Adds a view with findings. Errors: those of the encoder.
    [[nodiscard]] Result<void> addFinding(const check::FindingPicture& view);
    /// Adds a view without a finding. Errors: those of the encoder.
    [[nodiscard]] Result<void> addSample(const check::FindingPicture& view);
    /// Draws each kept view once more, with light and textures, as a further picture. Errors: the session's.
    [[nodiscard]] Result<void> addLitPictures(engine::Session& session);
    /// The report. Findings of an earlier part of a resumed run have no pictures.
    [[nodiscard]] CheckReport finish(ReportHead head, const check::Totals& totals) &&;

private:
    struct Kept {
        check::View view;
        CheckedView data;
    };
    [[nodiscard]] Result<Kept> keep(const check::FindingPicture& view) const;

    std::string worldOptions_;
    std::vector<Kept> findings_, samples_;
};

} // namespace limen::output
