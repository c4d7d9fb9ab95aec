// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/formula.hpp"

#include <numbers>

#include <fmt/format.h>
#include <muParser.h>

#include "coronet/core/error.hpp"

namespace coronet {

namespace {

/// muParser would take `x = 2` for an order to change x.
bool assigns(std::string const& text) {
    for (std::size_t k = text.find('='); k != std::string::npos; k = text.find('=', k + 1)) {
        bool const compares = (k > 0 && std::string("<>!=").find(text[k - 1]) != std::string::npos) ||
                              (k + 1 < text.size() && text[k + 1] == '=');
        if (!compares) return true;
    }
    return false;
}

}  // namespace

Formula::Formula(std::string const& text, std::map<std::string, double> const& parameters)
    : variable_(std::make_unique<Variables>()), parser_(std::make_unique<mu::Parser>()) {
    try {
        parser_->DefineVar("x", &variable_->x[0]);
        parser_->DefineVar("y", &variable_->x[1]);
        parser_->DefineVar("z", &variable_->x[2]);
        parser_->DefineVar("t", &variable_->t);
        parser_->DefineConst("pi", std::numbers::pi);
        for (auto const& [name, value] : parameters) {
            // muParser would let a parameter hide what it names itself.
            if (parser_->GetVar().contains(name) || parser_->GetConst().contains(name) ||
                parser_->GetFunDef().contains(name))
                throw CaseError(fmt::format("a parameter cannot be named '{}'", name));
            parser_->DefineConst(name, value);
        }
        if (assigns(text)) throw CaseError(fmt::format("the formula '{}' sets a variable; compare with ==", text));
        parser_->SetExpr(text);
        parser_->Eval();
        if (parser_->GetNumResults() != 1)
            throw CaseError(fmt::format("the formula '{}' has {} values, not one", text, parser_->GetNumResults()));
    } catch (mu::Parser::exception_type const& error) {
        std::string complaint = error.GetMsg();
        if (complaint.ends_with('.')) complaint.pop_back();
        throw CaseError(fmt::format("the formula '{}' is not understood: {}", text, complaint));
    }
}

Formula::~Formula() = default;
Formula::Formula(Formula&&) noexcept = default;

double Formula::evaluate() { return parser_->Eval(); }

}  // namespace coronet
