// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/read.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>
#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

#include "coronet/cases/builtin.hpp"
#include "coronet/cases/check.hpp"
#include "coronet/cases/fluid.hpp"
#include "coronet/cases/formula.hpp"
#include "coronet/cases/initial_frame.hpp"
#include "coronet/cases/nearest.hpp"
#include "coronet/cases/wall_check.hpp"
#include "coronet/core/error.hpp"

namespace coronet {

namespace {

std::vector<std::string> split(std::string const& path) {
    std::vector<std::string> parts;
    std::stringstream stream(path);
    for (std::string part; std::getline(stream, part, '.');) parts.push_back(part);
    return parts;
}

bool is_number(std::string const& text) {
    return !text.empty() && text.size() < 10 && text.find_first_not_of("0123456789") == std::string::npos;
}

toml::node* child(toml::node* node, std::string const& part) {
    if (auto* table = node->as_table()) return table->get(part);
    if (auto* array = node->as_array(); array && is_number(part)) return array->get(std::stoul(part));
    return nullptr;
}

/// As the user wrote it, as far as that is known: a float keeps its point.
std::string as_written(toml::node const& node) {
    if (auto const* array = node.as_array()) {
        std::vector<std::string> items;
        for (toml::node const& item : *array) items.push_back(as_written(item));
        return fmt::format("[{}]", fmt::join(items, ", "));
    }
    if (auto const* number = node.as_floating_point()) {
        std::string const text = fmt::format("{}", number->get());
        return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
    }
    std::ostringstream text;
    node.visit([&](auto const& value) {
        if constexpr (toml::is_table<decltype(value)>) text << "a table";
        else if constexpr (toml::is_string<decltype(value)>) text << "'" << value.get() << "'";
        else text << value;
    });
    return text.str();
}

std::string found(toml::node const& node) { return (node.is_string() ? "the string " : "") + as_written(node); }

std::string section_of(std::string const& path) { return path.substr(0, path.rfind('.')); }

/// Reads keys from a TOML table, remembers which it was asked for, and collects what is wrong.
class Reader final : public Keys {
public:
    Reader(toml::table& table, std::string file, std::set<std::string> set)
        : table_(table), file_(std::move(file)), set_(std::move(set)) {}

    void number(Key const& key, double& value) override {
        if (auto* node = want(key)) read_number(key, *node, value);
    }
    void integer(Key const& key, int& value) override {
        auto* node = want(key);
        if (!node) return;
        auto const whole = node->value_exact<std::int64_t>();
        if (!whole || *whole < -2147483647 || *whole > 2147483647)
            return wrong(key, *node, "must be a whole number" + range(key));
        if (check_range(key, *node, static_cast<double>(*whole), "whole")) value = static_cast<int>(*whole);
    }
    void text(Key const& key, std::string& value) override {
        auto* node = want(key);
        if (!node) return;
        if (auto const word = node->value_exact<std::string>()) value = *word;
        else wrong(key, *node, "must be a string");
    }
    void choice(Key const& key, std::string& value, Words const& allowed) override {
        auto* node = want(key);
        if (!node) return;
        auto const word = node->value_exact<std::string>();
        if (word && std::find(allowed.begin(), allowed.end(), *word) != allowed.end()) {
            value = *word;
            return;
        }
        if (key.path.ends_with(".kind")) of_unknown_kind_.insert(section_of(key.path));
        std::string const near = word ? nearest(*word, allowed) : "";
        wrong(key, *node,
              fmt::format("must be one of {}{}", fmt::join(allowed, ", "),
                          near.empty() ? "" : "; did you mean '" + near + "'?"));
    }
    void flag(Key const& key, bool& value) override {
        auto* node = want(key);
        if (!node) return;
        if (auto const truth = node->value_exact<bool>()) value = *truth;
        else wrong(key, *node, "must be true or false");
    }
    void number_or(Key const& key, double& value, std::string const& automatic) override {
        auto* node = want(key);
        if (!node) return;
        if (auto const word = node->value_exact<std::string>(); word && *word == automatic) value = 0;
        else if (node->is_number()) read_number(key, *node, value);
        else wrong(key, *node, fmt::format("must be a number{} or '{}'", unit(key), automatic));
    }
    void numbers(Key const& key, std::vector<double>& values, int size) override {
        auto* node = want(key);
        if (!node) return;
        auto* array = node->as_array();
        bool const even = size == any_even_size;
        if (!array || (even ? array->size() % 2 != 0 : array->size() != static_cast<std::size_t>(size)))
            return wrong(
                key, *node,
                fmt::format("must be a list of {} numbers{}", even ? "pairs of" : std::to_string(size), unit(key)));
        std::vector<double> read(array->size());
        for (std::size_t k = 0; k < array->size(); ++k)
            if (!read_number(key, *array->get(k), read[k])) return;
        values = read;
    }
    void formula(Key const& key, std::string& value) override {
        if (auto* node = want(key)) read_formula(key, *node, value);
    }
    void formulas(Key const& key, std::vector<std::string>& values, int size) override {
        auto* node = want(key);
        if (!node) return;
        auto* array = node->as_array();
        if (!array || array->size() != static_cast<std::size_t>(size))
            return wrong(key, *node, fmt::format("must be a list of {} formulas or numbers{}", size, unit(key)));
        std::vector<std::string> read(array->size());
        for (std::size_t k = 0; k < array->size(); ++k)
            if (!read_formula(key, *array->get(k), read[k])) return;
        values = read;
    }
    void named_numbers(Key const& key, std::map<std::string, double>& values) override {
        auto* node = want(key);
        if (!node) return;
        if (!node->is_table()) return wrong(key, *node, "must be a table of numbers");
        for (auto& [name, entry] : *node->as_table()) {
            Key const one{.path = key.path + "." + std::string(name.str()), .unit = "-", .meaning = ""};
            known_.push_back(one.path);
            double value = 0;
            if (!read_number(one, entry, value)) continue;
            values[std::string(name.str())] = value;
            try {
                Formula(std::string(name.str()), {{std::string(name.str()), value}});
            } catch (CaseError const&) {
                wrong(one, entry, "needs a name of letters, digits and _ that is not x, y, z, t, pi or a function");
                values.erase(std::string(name.str()));
            }
        }
        parameters_ = &values;
    }
    void tables(Key const& key, std::size_t, std::function<void(std::size_t)> const& resize,
                std::function<void(std::size_t, std::string const&)> const& item) override {
        auto* node = want(key);
        if (!node) return;
        auto* array = node->as_array();
        if (!array || (!array->empty() && !array->is_array_of_tables()) || (array->empty() && key.required))
            return wrong(key, *node, fmt::format("must be a list of tables, each begun by [[{}]]", key.path));
        resize(array->size());
        for (std::size_t k = 0; k < array->size(); ++k) {
            std::string const path = fmt::format("{}.{}", key.path, k);
            known_.push_back(path);
            item(k, path);
        }
    }

    /// Complains of the keys that nobody asked for; throws if anything was wrong.
    void finish() {
        find_unknown(table_, "");
        if (!errors_.empty()) throw CaseError(fmt::format("{}", fmt::join(errors_, "\n")));
    }

private:
    toml::node* want(Key const& key) {
        known_.push_back(key.path);
        toml::node* node = &table_;
        for (std::string const& part : split(key.path)) {
            node = child(node, part);
            if (!node) break;
        }
        if (!node && key.required && !of_unknown_kind_.contains(section_of(key.path)))
            errors_.push_back(fmt::format("{}: {} is missing: {}{}", file_, key.path, key.meaning, unit(key)));
        return node;
    }

    static std::string unit(Key const& key) { return key.unit.empty() || key.unit == "-" ? "" : " [" + key.unit + "]"; }
    static std::string range(Key const& key) {
        std::vector<std::string> bounds;
        if (std::isfinite(key.at_least)) bounds.push_back(fmt::format("at least {}", key.at_least));
        if (std::isfinite(key.above)) bounds.push_back(fmt::format("above {}", key.above));
        if (std::isfinite(key.at_most)) bounds.push_back(fmt::format("at most {}", key.at_most));
        return bounds.empty() ? "" : fmt::format(", {}", fmt::join(bounds, " and "));
    }

    void wrong(Key const& key, toml::node const& node, std::string const& right) {
        errors_.push_back(fmt::format("{}: {} is {}, but {}", place(key.path, node), key.path, found(node), right));
    }
    std::string place(std::string const& path, toml::node const& node) const {
        bool const added = node.source().begin.line == 0;  // a section that --set had to make
        for (std::string const& setting : set_)
            if (path == setting || path.starts_with(setting + ".") || (added && setting.starts_with(path + ".")))
                return "--set " + setting;
        return fmt::format("{}:{}", file_, node.source().begin.line);
    }

    bool check_range(Key const& key, toml::node const& node, double value, std::string const& kind = "finite") {
        bool const inside = std::isfinite(value) && value >= key.at_least && value > key.above && value <= key.at_most;
        if (!inside) wrong(key, node, fmt::format("must be a {} number{}{}", kind, unit(key), range(key)));
        return inside;
    }
    bool read_number(Key const& key, toml::node const& node, double& value) {
        auto const number = node.is_number() ? node.value<double>() : std::nullopt;
        if (!number) {
            wrong(key, node, fmt::format("must be a number{}{}", unit(key), range(key)));
            return false;
        }
        if (!check_range(key, node, *number)) return false;
        value = *number;
        return true;
    }
    bool read_formula(Key const& key, toml::node const& node, std::string& value) {
        if (node.is_number()) {
            double number = 0;
            if (!read_number(key, node, number)) return false;
            value = fmt::format("{}", number);
            return true;
        }
        auto const text = node.value_exact<std::string>();
        if (!text) {
            wrong(key, node, "must be a formula of x, y, z, t and the parameters, or a number" + unit(key));
            return false;
        }
        try {
            Formula(*text, parameters_ ? *parameters_ : std::map<std::string, double>{});
        } catch (CaseError const& error) {
            errors_.push_back(fmt::format(
                "{}: {}: {}; it may use x, y, z, t, pi and the parameters, "
                "+ - * / ^, sqrt, exp, ln, sin, cos, tan, atan2, abs, min, max, comparisons, &&, || and a ? b : c",
                place(key.path, node), key.path, error.what()));
            return false;
        }
        value = *text;
        return true;
    }

    /// What to write instead of `part` in the section `path`: a key of that section, else one of another.
    std::string advice(std::string const& part, std::string const& path) const {
        std::vector<std::string> beside, last;
        std::string const prefix = path.empty() ? "" : path + ".";
        for (std::string const& key : known_) {
            if (key.starts_with(prefix)) {
                std::string const name = split(key.substr(prefix.size())).front();
                if (std::find(beside.begin(), beside.end(), name) == beside.end()) beside.push_back(name);
            }
            last.push_back(split(key).back());
        }
        if (std::string const near = nearest(part, beside); !near.empty())
            return fmt::format("did you mean {}{}?", prefix, near);
        auto const elsewhere = std::find(last.begin(), last.end(), nearest(part, last));
        if (elsewhere != last.end())
            return fmt::format("did you mean {}?", known_[static_cast<std::size_t>(elsewhere - last.begin())]);
        if (path.empty()) return "`coronet keys` lists them all";
        return fmt::format("{} has {}", path, fmt::join(beside, ", "));
    }

    void find_unknown(toml::node& node, std::string const& path) {
        if (of_unknown_kind_.contains(path)) return;
        auto const visit = [&](std::string const& part, toml::node& below) {
            std::string const here = path.empty() ? part : path + "." + part;
            bool const is_key = std::find(known_.begin(), known_.end(), here) != known_.end();
            bool const is_section = std::any_of(known_.begin(), known_.end(),
                                                [&](std::string const& key) { return key.starts_with(here + "."); });
            if (is_section && !below.is_table() && !below.is_array()) {
                errors_.push_back(fmt::format("{}: {} is {}, but must be a table: [{}]", place(here, below), here,
                                              found(below), here));
            } else if (is_section) {
                find_unknown(below, here);
            } else if (!is_key) {
                errors_.push_back(
                    fmt::format("{}: {} is no key here; {}", place(here, below), here, advice(part, path)));
            }
        };
        if (auto* table = node.as_table())
            for (auto& [name, below] : *table) visit(std::string(name.str()), below);
        else if (auto* array = node.as_array())
            for (std::size_t k = 0; k < array->size(); ++k) visit(fmt::format("{}", k), *array->get(k));
    }

    toml::table& table_;
    std::string file_;
    std::set<std::string> set_, of_unknown_kind_;  // tables whose keys nobody can tell
    std::map<std::string, double> const* parameters_ = nullptr;
    std::vector<std::string> known_, errors_;
};

/// Puts "path.to.key=value" into the table; a bare word on the right is a string.
std::string override_key(toml::table& table, std::string const& setting) {
    auto const equals = setting.find('=');
    if (equals == std::string::npos || equals == 0)
        throw CaseError(fmt::format("--set {}: must have the form path.to.key=value", setting));
    std::string const path = setting.substr(0, equals), right = setting.substr(equals + 1);

    toml::table parsed;
    try {
        parsed = toml::parse("value = " + right);
        if (parsed.size() != 1) throw CaseError(fmt::format("--set {}: must set one value", setting));
    } catch (toml::parse_error const&) {
        parsed = toml::table{};
        parsed.insert("value", right);
    }

    auto const parts = split(path);
    if (path.ends_with('.') || std::count(parts.begin(), parts.end(), "") > 0)
        throw CaseError(fmt::format("--set {}: {} has an empty part", setting, path));
    toml::node* node = &table;
    for (std::size_t k = 0; k + 1 < parts.size(); ++k) {
        toml::node* below = child(node, parts[k]);
        if (!below && node->is_table()) {
            node->as_table()->insert(parts[k], toml::table{});
            below = child(node, parts[k]);
        }
        if (!below || !(below->is_table() || below->is_array()))
            throw CaseError(
                fmt::format("--set {}: {} is not a table or a list's item in this case", setting,
                            fmt::join(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(k) + 1, ".")));
        node = below;
    }
    if (auto* inner = node->as_table()) {
        inner->insert_or_assign(parts.back(), std::move(*parsed.get("value")));
    } else if (auto* array = node->as_array();
               array && is_number(parts.back()) && std::stoul(parts.back()) < array->size()) {
        auto const at = array->begin() + static_cast<std::ptrdiff_t>(std::stoul(parts.back()));
        array->insert(array->erase(at), std::move(*parsed.get("value")));
    } else {
        throw CaseError(fmt::format("--set {}: there is no item {} in that list", setting, parts.back()));
    }
    return path;
}

}  // namespace

Case read_case(std::string_view text, std::string const& file, std::vector<std::string> const& settings) {
    toml::table table;
    try {
        table = toml::parse(text, file);
    } catch (toml::parse_error const& error) {
        throw CaseError(fmt::format("{}:{}: this is not TOML: {} (words need quotes)", file, error.source().begin.line,
                                    error.description()));
    }
    std::set<std::string> set;
    for (std::string const& setting : settings) set.insert(override_key(table, setting));

    Reader reader(table, file, set);
    Case c;
    describe(reader, c);
    reader.finish();
    if (!c.fluid.flow_curve.empty()) fit_rheology(c, file);
    read_surfaces(c, file);
    if (!c.initial.from.empty()) read_initial_frame(c, file);
    check_physics(c, file);
    return c;
}

Case load_case(std::string const& name_or_path, std::vector<std::string> const& settings) {
    for (BuiltinFile const& known : builtin_cases())
        if (known.name == name_or_path)
            return read_case(known.text, fmt::format("built-in case {}", known.name), settings);

    std::ifstream file(name_or_path);
    if (!file || std::filesystem::is_directory(name_or_path)) {
        std::vector<std::string> names;
        for (BuiltinFile const& known : builtin_cases()) names.emplace_back(known.name);
        std::string const near = nearest(name_or_path, names);
        throw CaseError(
            fmt::format("there is no file '{}' that can be read and no built-in case of that name{}; built in are {}",
                        name_or_path, near.empty() ? "" : " (did you mean " + near + "?)", fmt::join(names, ", ")));
    }
    std::stringstream text;
    text << file.rdbuf();
    return read_case(text.str(), name_or_path, settings);
}

}  // namespace coronet
