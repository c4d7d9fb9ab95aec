// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/formula.hpp"

#include <numbers>

#include <fmt/format.h>
#include <muParser.h>

#include "coronet/core/error.hpp"

namespace coronet {

Formula::Formula(std::string const& text, std::map<std::string, double> const& parameters)
    : variable_(std::make_unique<Variables>()), parser_(std::make_unique<mu::Parser>()) {
    try {
        parser_->DefineVar("x", &variable_->x[0]);
        parser_->DefineVar("y", &variable_->x[1]);
        parser_->DefineVar("z", &variable_->x[2]);
        parser_->DefineVar("t", &variable_->t);
        parser_->DefineConst("pi", std::numbers::pi);
        for (auto const& [name, value] : parameters) parser_->DefineConst(name, value);
        parser_->SetExpr(text);
        parser_->Eval();
    } catch (mu::Parser::exception_type const& error) {
        throw CaseError(fmt::format("the formula '{}' is not understood: {}", text, error.GetMsg()));
    }
}

Formula::~Formula() = default;
Formula::Formula(Formula&&) noexcept = default;

double Formula::evaluate() { return parser_->Eval(); }

}  // namespace coronet
