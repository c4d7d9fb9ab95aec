// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "coronet/cases/read.hpp"

namespace coronet {

namespace {

std::string in_quotes(std::string const& text) {
    std::string out = "\"";
    for (char const c : text) {
        if (c == '"' || c == '\\') out += '\\';
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) out += fmt::format("\\u{:04x}", static_cast<int>(c));
        else out += c;
    }
    return out + '"';
}

/// The shortest digits that read back as the same number; a TOML float has a point or an exponent.
std::string digits(double value) {
    std::string text = fmt::format("{}", value);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

std::string without_indices(std::string const& path) {
    std::string out;
    for (std::size_t k = 0; k < path.size(); ++k) {
        if (path[k] == '.' && k + 1 < path.size() && std::isdigit(static_cast<unsigned char>(path[k + 1]))) {
            while (k + 1 < path.size() && path[k + 1] != '.') ++k;
        } else {
            out += path[k];
        }
    }
    return out;
}

/// Writes every key with its value, section by section.
class Writer final : public Keys {
public:
    std::string toml;

    void number(Key const& key, double& value) override { put(key, digits(value)); }
    void integer(Key const& key, int& value) override { put(key, fmt::format("{}", value)); }
    void text(Key const& key, std::string& value) override { put(key, in_quotes(value)); }
    void choice(Key const& key, std::string& value, Words const&) override { put(key, in_quotes(value)); }
    void flag(Key const& key, bool& value) override { put(key, value ? "true" : "false"); }
    void formula(Key const& key, std::string& value) override { put(key, in_quotes(value)); }
    void number_or(Key const& key, double& value, std::string const& automatic) override {
        put(key, value == 0 ? in_quotes(automatic) : digits(value));
    }
    void numbers(Key const& key, std::vector<double>& values, int) override {
        std::vector<std::string> items;
        for (double const value : values) items.push_back(digits(value));
        put(key, fmt::format("[{}]", fmt::join(items, ", ")));
    }
    void formulas(Key const& key, std::vector<std::string>& values, int) override {
        std::vector<std::string> items;
        for (std::string const& value : values) items.push_back(in_quotes(value));
        put(key, fmt::format("[{}]", fmt::join(items, ", ")));
    }
    void named_numbers(Key const& key, std::map<std::string, double>& values) override {
        for (auto const& [name, value] : values)
            put({.path = key.path + "." + name, .unit = "", .meaning = ""}, digits(value));
    }
    void tables(Key const& key, std::size_t count, std::function<void(std::size_t)> const&,
                std::function<void(std::size_t, std::string const&)> const& item) override {
        for (std::size_t k = 0; k < count; ++k) {
            section_ = fmt::format("{}.{}", key.path, k);
            toml += fmt::format("\n[[{}]]\n", without_indices(section_));
            item(k, section_);
        }
    }

private:
    void put(Key const& key, std::string const& value) {
        auto const dot = key.path.rfind('.');
        std::string const section = dot == std::string::npos ? "" : key.path.substr(0, dot);
        if (section != section_) {
            section_ = section;
            toml += fmt::format("\n[{}]\n", section);
        }
        toml += fmt::format("{} = {}{}\n", dot == std::string::npos ? key.path : key.path.substr(dot + 1), value,
                            key.unit.empty() || key.unit == "-" ? "" : "  # " + key.unit);
    }

    std::string section_;
};

/// Lists every key with unit, default and meaning.
class Page final : public Keys {
public:
    std::string markdown = "| key | value | default | meaning |\n|---|---|---|---|\n";

    bool everything() const override { return true; }
    void number(Key const& key, double& value) override {
        bool const derived = std::isnan(value) || (value == 0 && key.above == 0);
        row(key, "number", derived ? "" : fmt::format("{}", value));
    }
    void integer(Key const& key, int& value) override { row(key, "whole number", fmt::format("{}", value)); }
    void text(Key const& key, std::string& value) override { row(key, "string", value); }
    void choice(Key const& key, std::string& value, Words const& allowed) override {
        row(key, fmt::format("`{}`", fmt::join(allowed, "`, `")), value);
    }
    void flag(Key const& key, bool& value) override { row(key, "`true`, `false`", value ? "true" : "false"); }
    void number_or(Key const& key, double& value, std::string const& automatic) override {
        row(key, "number or `" + automatic + "`", value == 0 ? automatic : fmt::format("{}", value));
    }
    void numbers(Key const& key, std::vector<double>& values, int) override {
        row(key, "a number per dimension", fmt::format("[{}]", fmt::join(values, ", ")));
    }
    void formula(Key const& key, std::string& value) override { row(key, "formula", value); }
    void formulas(Key const& key, std::vector<std::string>& values, int) override {
        row(key, "a formula per dimension", fmt::format("[{}]", fmt::join(values, ", ")));
    }
    void named_numbers(Key const& key, std::map<std::string, double>&) override { row(key, "a table of numbers", ""); }
    void tables(Key const& key, std::size_t, std::function<void(std::size_t)> const& resize,
                std::function<void(std::size_t, std::string const&)> const& item) override {
        row(key, "a list of tables", "");
        resize(1);
        item(0, key.path + ".0");
    }

private:
    void row(Key const& key, std::string const& kind, std::string const& standard) {
        std::string bounds;
        if (std::isfinite(key.at_least)) bounds += fmt::format(", at least {}", key.at_least);
        if (std::isfinite(key.above)) bounds += fmt::format(", above {}", key.above);
        if (std::isfinite(key.at_most)) bounds += fmt::format(", at most {}", key.at_most);
        std::string const unit = key.unit.empty() || key.unit == "-" ? "" : " [" + key.unit + "]";
        markdown += fmt::format("| `{}` | {}{}{} | {} | {} |\n", without_indices(key.path), kind, unit, bounds,
                                key.required       ? "required"
                                : standard.empty() ? ""
                                                   : "`" + standard + "`",
                                key.meaning);
    }
};

}  // namespace

std::string write_case(Case const& c) {
    Case copy = c;
    Writer writer;
    describe(writer, copy);
    return writer.toml;
}

std::string keys_page() {
    Page page;
    Case c;
    describe(page, c);
    return page.markdown;
}

}  // namespace coronet
