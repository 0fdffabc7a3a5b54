// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/glass/agf.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "dewbow/base/parse_number.h"
#include "dewbow/import/glass/agf_text.h"

namespace dewbow::glass_import {
namespace {

constexpr int kFormulas = 13;
constexpr std::size_t kMostCoefficients = 10;
constexpr std::size_t kMostGlasses = 100'000;
/// Makers round n_d to five or six decimals; what is further off has its coefficients in another
/// order, or another formula.
constexpr double kIndexTolerance = 1e-4;
constexpr double kMostMicrometres = 1000.0;

using Words = std::vector<std::string_view>;

Words words_of(std::string_view line) {
    constexpr std::string_view kSpaces = " \t";
    Words words;
    for (;;) {
        const std::size_t start = line.find_first_not_of(kSpaces);
        if (start == std::string_view::npos) return words;
        const std::size_t end = std::min(line.find_first_of(kSpaces, start), line.size());
        words.push_back(line.substr(start, end - start));
        line.remove_prefix(end);
    }
}

std::optional<double> finite_number(std::string_view word) {
    const auto value = parse_number<double>(word);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

/// A glass as its record says it.
struct Record {
    std::size_t line = 0;
    std::string name;
    int formula = 0;
    double n_d = 0.0, v_d = 0.0;
    std::vector<double> coefficients;
    double low_um = 0.0, high_um = 0.0;
    std::vector<Extinction> k;
};

class AgfReader {
public:
    AgfReader(const std::string& file, const std::string& group) : file_(file), group_(group) {}

    GlassFile read(std::string_view bytes) {
        const TextLines text = lines_of_text(bytes);
        for (const std::string& finding : text.findings) note(0, finding);
        for (const std::string& line : text.lines) read_line(++line_, line);
        finish_record();
        note_counts();
        if (records_ == 0)
            throw InputError(SourcePlace{file_, 0, 0, {}},
                             "no glass in it: expected lines that begin with NM");
        return std::move(result_);
    }

private:
    void note(std::size_t line, const std::string& text) {
        result_.notes.push_back({{file_, line, 0, {}}, text});
    }

    void read_line(std::size_t number, std::string_view line) {
        const Words words = words_of(line);
        if (words.empty() || words[0].starts_with('!')) return;
        const bool wrapped = wraps_ && finite_number(words[0]);
        if (wrapped) {
            ++wrapped_lines_;
            if (reads_coefficients_) add_coefficients(words, 0);
            return;
        }
        const std::string_view key = words[0];
        wraps_ = key == "CD" || key == "TD";
        reads_coefficients_ = key == "CD";
        if (key == "NM")
            start_record(number, words);
        else if (!record_)
            return;
        else if (key == "CD")
            add_coefficients(words, 1);
        else if (key == "LD")
            read_range(words);
        else if (key == "IT")
            read_transmittance(words);
    }

    void start_record(std::size_t number, const Words& words) {
        finish_record();
        if (++records_ > kMostGlasses)
            throw InputError(SourcePlace{file_, number, 0, {}},
                             fmt::format("more than {} glasses", kMostGlasses));
        const auto formula = words.size() > 2 ? finite_number(words[2]) : std::nullopt;
        if (!formula || *formula != std::floor(*formula) || *formula < 1 || *formula > kFormulas) {
            note(number,
                 fmt::format("{}: {} as the formula; expected a number from 1 to {}: left out",
                             words.size() > 1 ? words[1] : "a glass without a name",
                             words.size() > 2 ? words[2] : "nothing", kFormulas));
            return;
        }
        record_.emplace();
        record_->line = number;
        record_->name = std::string(words[1]);
        record_->formula = static_cast<int>(*formula);
        record_->n_d = field(words, 4);
        record_->v_d = field(words, 5);
        if (record_->n_d == 1.0) {
            ++placeholders_;
            record_->n_d = record_->v_d = 0.0;
        }
    }

    /// A number, or 0 where it is missing or "-".
    double field(const Words& words, std::size_t index) {
        const auto value = index < words.size() ? finite_number(words[index]) : std::nullopt;
        if (!value) ++missing_fields_;
        return value && *value > 0.0 ? *value : 0.0;
    }

    void add_coefficients(const Words& words, std::size_t first) {
        if (!record_) return;
        for (std::size_t i = first; i < words.size(); ++i) {
            const auto value = finite_number(words[i]);
            if (!value) ++missing_fields_;
            if (record_->coefficients.size() < kMostCoefficients)
                record_->coefficients.push_back(value.value_or(0.0));
        }
    }

    void read_range(const Words& words) {
        record_->low_um = field(words, 1);
        record_->high_um = field(words, 2);
    }

    /// τ of a plate of thickness t is exp(−4πkt/λ).
    void read_transmittance(const Words& words) {
        if (words.size() < 4) return;
        const auto lambda_um = finite_number(words[1]);
        const auto tau = finite_number(words[2]), thickness_mm = finite_number(words[3]);
        if (!lambda_um || !tau || !thickness_mm) return;
        if (!(*lambda_um > 0.0 && *lambda_um<kMostMicrometres&& * tau> 0.0 && *tau <= 1.0 &&
              *thickness_mm > 0.0))
            return;
        const double k =
            -std::log(*tau) * *lambda_um / (4.0 * std::numbers::pi * 1e3 * *thickness_mm);
        record_->k.push_back({1e3 * *lambda_um, k + 0.0});
    }

    void finish_record() {
        if (!record_) return;
        const Record record = std::move(*record_);
        record_.reset();
        if (record.coefficients.empty()) {
            note(record.line, record.name + ": no coefficients (CD): left out");
            return;
        }
        try {
            add(record, glass_from(record));
        } catch (const InputError& error) {
            note(record.line, fmt::format("{}: {}: left out", record.name, error.sentence()));
        }
    }

    Glass glass_from(const Record& record) {
        Glass glass;
        glass.name = group_ + "/" + record.name;
        glass.description = "of " + file_;
        glass.data = {fmt::format("agf_{}", record.formula), record.coefficients,
                      IndexReference::air};
        if (record.low_um > 0.0 && record.high_um > record.low_um &&
            record.high_um < kMostMicrometres) {
            glass.lambda_min_nm = 1e3 * record.low_um;
            glass.lambda_max_nm = 1e3 * record.high_um;
            glass.data.range = DataRange{glass.lambda_min_nm, glass.lambda_max_nm};
        } else {
            ++without_range_;
        }
        glass.n_d = record.n_d;
        glass.v_d = record.v_d;
        glass.k = record.k;
        std::sort(glass.k.begin(), glass.k.end(),
                  [](const auto& a, const auto& b) { return a.lambda_nm < b.lambda_nm; });
        glass.k.erase(
            std::unique(glass.k.begin(), glass.k.end(),
                        [](const auto& a, const auto& b) { return a.lambda_nm == b.lambda_nm; }),
            glass.k.end());
        glass.source = file_;
        return glass;
    }

    void add(const Record& record, Glass glass) {
        const DispersionPtr dispersion = make_dispersion(glass.data);
        if (glass.n_d > 0.0) {
            const double n_d = (*dispersion)(kLined).value / (*air())(kLined).value;
            if (!(std::abs(n_d - glass.n_d) <= kIndexTolerance))
                note(record.line,
                     fmt::format(
                         "{}: its coefficients give n_d {:.6f}, and NM says {:.6f}: are they "
                         "in another order, or of another formula than {}?",
                         record.name, n_d, glass.n_d, record.formula));
        }
        if (!names_.insert(glass.name).second) {
            note(record.line, record.name + ": a second glass of this name: left out");
            return;
        }
        result_.glasses.push_back(std::move(glass));
    }

    void note_counts() {
        const auto count = [&](std::size_t number, const char* what) {
            if (number > 0) note(0, fmt::format("{} {}", number, what));
        };
        count(wrapped_lines_, "wrapped lines of CD or TD, which were joined");
        count(placeholders_, "glasses with n_d 1 as a placeholder: their n_d is not known");
        count(missing_fields_,
              "fields missing or no number (\"-\"), which were taken as not known");
        count(without_range_, "glasses without a range (LD)");
    }

    const std::string file_, group_;
    GlassFile result_;
    std::optional<Record> record_;
    std::set<std::string> names_;
    bool wraps_ = false, reads_coefficients_ = false;
    std::size_t line_ = 0, records_ = 0;
    std::size_t wrapped_lines_ = 0, placeholders_ = 0, missing_fields_ = 0, without_range_ = 0;
};

}  // namespace

GlassFile read_agf(std::string_view bytes, const std::string& file, const std::string& group) {
    return AgfReader(file, group).read(bytes);
}

}  // namespace dewbow::glass_import
