#include "output/report/Template.h"

#include "core/Assert.h"
#include "output/report/Escape.h"

#include <nlohmann/json.hpp>
#include <vector>

namespace limen::output {
namespace {

using TemplateValue = nlohmann::ordered_json;

class TemplateFiller {
public:
    TemplateFiller(std::string_view text, const TemplateValue& values) : text_(text), scopes_{&values} {}

    std::string fill() {
        fillUntil("", true);
        return std::move(out_);
    }

private:
    struct Tag {
        char kind = ' '; ///< '#', '^', '/', '{' (unescaped) or ' ' (escaped)
        std::string_view name;
    };

    /// Appends the text up to the next tag and returns that tag. Null name: the end of the template.
    Tag nextTag(bool isShown) {
        const std::size_t open = text_.find("{{", at_);
        if (isShown)
            out_ += text_.substr(at_, open == std::string_view::npos ? open : open - at_);
        if (open == std::string_view::npos) {
            at_ = text_.size();
            return {};
        }
        Tag tag;
        const char first = text_[open + 2];
        const bool isMarked = first == '#' || first == '^' || first == '/' || first == '{';
        tag.kind = isMarked ? first : ' ';
        const std::string_view end = first == '{' ? "}}}" : "}}";
        const std::size_t begin = open + (isMarked ? 3 : 2), close = text_.find(end, begin);
        LIMEN_ASSERT(close != std::string_view::npos, "each tag of a template is closed");
        tag.name = text_.substr(begin, close - begin);
        at_ = close + end.size();
        return tag;
    }

    const TemplateValue& find(std::string_view name) const {
        if (name == ".")
            return *scopes_.back();
        for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope)
            if ((*scope)->is_object())
                if (const auto found = (*scope)->find(name); found != (*scope)->end())
                    return *found;
        LIMEN_ASSERT(false, "a template uses known names");
        return *scopes_.front();
    }

    static std::string textOf(const TemplateValue& value) {
        if (value.is_string())
            return value.get<std::string>();
        return value.is_null() ? "" : value.dump(-1, ' ', false, TemplateValue::error_handler_t::replace);
    }

    static bool isEmpty(const TemplateValue& value) {
        return value.is_null() || value == false || (value.is_string() && value.get<std::string>().empty()) ||
               (value.is_array() && value.empty());
    }

    void section(const Tag& tag, bool isShown) {
        const std::size_t body = at_;
        if (!isShown) {
            fillUntil(tag.name, false);
            return;
        }
        const TemplateValue& value = find(tag.name);
        const bool isInverted = tag.kind == '^';
        if (isEmpty(value) != isInverted) {
            fillUntil(tag.name, false);
            return;
        }
        if (isInverted || !(value.is_array() || value.is_object())) {
            fillUntil(tag.name, true);
            return;
        }
        const auto once = [&](const TemplateValue& item) {
            at_ = body;
            scopes_.push_back(&item);
            fillUntil(tag.name, true);
            scopes_.pop_back();
        };
        if (value.is_object())
            return once(value);
        for (const TemplateValue& item : value)
            once(item);
    }

    /// Fills up to the end of the section `name`; "": of the template.
    void fillUntil(std::string_view name, bool isShown) {
        for (;;) {
            const Tag tag = nextTag(isShown);
            if (tag.name.data() == nullptr || tag.kind == '/') {
                LIMEN_ASSERT(tag.name == name, "sections of a template are nested");
                return;
            }
            if (tag.kind == '#' || tag.kind == '^')
                section(tag, isShown);
            else if (isShown)
                out_ += tag.kind == '{' ? textOf(find(tag.name)) : escapeHtml(textOf(find(tag.name)));
        }
    }

    std::string_view text_;
    std::vector<const TemplateValue*> scopes_;
    std::size_t at_ = 0;
    std::string out_;
};

} // namespace

std::string fillTemplate(std::string_view text, const nlohmann::ordered_json& values) {
    return TemplateFiller(text, values).fill();
}

} // namespace limen::output
