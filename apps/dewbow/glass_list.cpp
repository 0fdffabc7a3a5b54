// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "command.h"
#include "console.h"
#include "dewbow/base/error.h"
#include "glass_facts.h"

namespace dewbow {
namespace {

using Json = nlohmann::ordered_json;

std::string lower(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

bool matches(const Glass& glass, const std::string& filter) {
    const auto has = [&](const std::string& text) {
        return lower(text).find(filter) != std::string::npos;
    };
    return has(glass.name) || has(glass.description) ||
           std::any_of(glass.aliases.begin(), glass.aliases.end(), has);
}

std::vector<Glass> glasses_of(const std::string& filter) {
    std::vector<Glass> found;
    for (const Glass& glass : glass_catalogue())
        if (matches(glass, lower(filter))) found.push_back(glass);
    if (found.empty())
        throw UsageError(fmt::format("no glass has \"{}\" in its name or description", filter),
                         "`dewbow glass list` shows all");
    return found;
}

std::string json_of(const std::vector<Glass>& glasses) {
    Json list = Json::array();
    const auto published = [](double value) { return value > 0.0 ? Json(value) : Json(nullptr); };
    for (const Glass& glass : glasses)
        list.push_back({{"name", glass.name},
                        {"aliases", glass.aliases},
                        {"n_d", published(glass.n_d)},
                        {"V_d", published(glass.v_d)},
                        {"description", glass.description}});
    return list.dump() + "\n";
}

std::string text_of(const std::vector<Glass>& glasses) {
    std::size_t width = 4;
    for (const Glass& glass : glasses) width = std::max(width, glass.name.size());
    std::string text = fmt::format("{:<{}}  n_d      V_d     description\n", "name", width);
    const auto published = [](double value, int digits) {
        return value > 0.0 ? fmt::format("{:.{}f}", value, digits) : std::string("-");
    };
    for (const Glass& glass : glasses) {
        text += fmt::format("{:<{}}  {:<7}  {:<6}  {}", glass.name, width, published(glass.n_d, 5),
                            published(glass.v_d, 2), glass.description);
        if (!glass.aliases.empty()) text += fmt::format(" (also {})", joined(glass.aliases));
        text += '\n';
    }
    return text;
}

}  // namespace

int run(const GlassListCommand& command) {
    const std::vector<Glass> glasses = glasses_of(command.filter);
    print_data(command.json ? json_of(glasses) : text_of(glasses));
    return kDone;
}

}  // namespace dewbow
