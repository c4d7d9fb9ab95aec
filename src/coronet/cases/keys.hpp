// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The language in which the schema of a case is written: every key is described once, with its place, unit, meaning and
// allowed values, by showing it to a Keys visitor. One visitor reads keys from a file and checks them, one writes the
// case as run, one writes the reference page of all keys.

#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace coronet {

struct Key {
    std::string path;          ///< dotted, as in --set
    std::string unit = {};     ///< "-" for a pure number, empty for words
    std::string meaning = {};  ///< a phrase
    double at_least = -std::numeric_limits<double>::infinity();
    double above = -std::numeric_limits<double>::infinity();
    double at_most = std::numeric_limits<double>::infinity();
    bool required = false;
};

class Keys {
public:
    using Words = std::vector<std::string>;

    virtual ~Keys() = default;

    virtual void number(Key const& key, double& value) = 0;
    virtual void integer(Key const& key, int& value) = 0;
    virtual void text(Key const& key, std::string& value) = 0;
    virtual void choice(Key const& key, std::string& value, Words const& allowed) = 0;
    virtual void flag(Key const& key, bool& value) = 0;
    /// A number, or the word `automatic`, which stands for 0.
    virtual void number_or(Key const& key, double& value, std::string const& automatic) = 0;
    static constexpr int any_even_size = -2;
    /// `size` numbers.
    virtual void numbers(Key const& key, std::vector<double>& values, int size) = 0;
    /// A formula (or number) of x, y, z, t and the case's parameters.
    virtual void formula(Key const& key, std::string& value) = 0;
    /// `size` formulas.
    virtual void formulas(Key const& key, std::vector<std::string>& values, int size) = 0;
    /// Numbers under names that the user makes up.
    virtual void named_numbers(Key const& key, std::map<std::string, double>& values) = 0;
    /// A list of tables: `resize` sets how many there are, `item(k, path)` describes the k-th.
    virtual void tables(Key const& key, std::size_t count, std::function<void(std::size_t)> const& resize,
                        std::function<void(std::size_t, std::string const& path)> const& item) = 0;

    /// True for the visitor that wants all keys, also those that other keys rule out.
    virtual bool everything() const { return false; }
};

}  // namespace coronet
