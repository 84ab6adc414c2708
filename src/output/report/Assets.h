#pragma once

#include <string_view>

// The files of src/output/report/assets, embedded by the build.
namespace limen::output::assets {

extern const std::string_view kStyleCss, kCommonJs, kPlotJs, kGraphJs, kTourJs;
/// Of a page: the head up to the facts and the command, then the body.
extern const std::string_view kHeadHtml, kTourHtml, kCheckHtml;

} // namespace limen::output::assets
