// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A field given as a formula of x, y, z [m], t [s] and the case's parameters, evaluated by muParser: + - * / ^, sin,
// cos, exp, sqrt, abs, min, max, comparisons, (a ? b : c), and pi.

#include <map>
#include <memory>
#include <string>

#include "coronet/core/tensor.hpp"

namespace mu {
class Parser;
}

namespace coronet {

class Formula {
public:
    /// Throws CaseError with the parser's complaint if the text is no formula of these names.
    Formula(std::string const& text, std::map<std::string, double> const& parameters);
    ~Formula();
    Formula(Formula&&) noexcept;

    template <int D>
    double operator()(Vector<double, D> const& x, double t) {
        for (int k = 0; k < D; ++k) variable_->x[k] = x[k];
        variable_->t = t;
        return evaluate();
    }

private:
    struct Variables {
        double x[3] = {};
        double t = 0;
    };
    double evaluate();

    std::unique_ptr<Variables> variable_;
    std::unique_ptr<mu::Parser> parser_;
};

}  // namespace coronet
