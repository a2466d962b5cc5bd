// SPDX-License-Identifier: MIT
#include "expression/expression_source.h"

#include "base/error.h"

#include <muParser.h>

#include <cctype>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string_view>

namespace tessera
{

namespace
{

constexpr std::size_t kLongest = 4000;

/// A parser and the variables that it reads. Neither copied nor moved: the parser knows where the
/// variables are.
class Expression
{
public:
    explicit Expression(const std::string& text)
    {
        parser_.DefineVar("x", &x_);
        parser_.DefineVar("y", &y_);
        parser_.DefineConst("pi", std::numbers::pi);
        parser_.SetExpr(text);
        parser_.Eval();
        if (parser_.GetNumResults() != 1) {
            throw std::string("it gives several values; write a decimal point, no comma");
        }
    }
    Expression(const Expression&) = delete;
    Expression& operator=(const Expression&) = delete;

    double operator()(Vec2 p)
    {
        x_ = p.x;
        y_ = p.y;
        const double value = parser_.Eval();
        return std::isnan(value) ? std::numeric_limits<double>::quiet_NaN() : value; // without sign
    }

private:
    double x_ = 0.0;
    double y_ = 0.0;
    mu::Parser parser_;
};

[[noreturn]] void refuse(const std::string& text, std::string reason)
{
    if (!reason.empty() && reason.back() == '.') {
        reason.pop_back();
    }
    throw Error(ErrorKind::InvalidOption,
                "The size expression '" + text.substr(0, 100) + "' cannot be read: " + reason
                    + "; use x, y, numbers, + - * / ^ and functions such as sqrt, exp, min.");
}

/// Position of a single =, which would set a variable; npos if there is none.
std::size_t findAssignment(const std::string& text)
{
    for (std::size_t i = text.find('='); i != std::string::npos; i = text.find('=', i + 1)) {
        if (i + 1 < text.size() && text[i + 1] == '=') {
            ++i;
        }
        else if (i == 0 || std::string_view("<>!").find(text[i - 1]) == std::string_view::npos) {
            return i;
        }
    }
    return std::string::npos;
}

/// What those mean who write it as in another language; empty: nothing known.
std::string hintFor(const std::string& text)
{
    if (text.find("**") != std::string::npos) {
        return "; write ^ for a power";
    }
    for (std::size_t i = text.find("if"); i != std::string::npos; i = text.find("if", i + 1)) {
        const bool begins = i == 0 || std::isalnum(static_cast<unsigned char>(text[i - 1])) == 0;
        const bool ends = i + 2 == text.size()
            || std::isalnum(static_cast<unsigned char>(text[i + 2])) == 0;
        if (begins && ends) {
            return "; write condition ? size : other size";
        }
    }
    return text.find('?') == std::string::npos ? "" : "; write condition ? size : other size";
}

} // namespace

AreaSource expressionSource(const std::string& expression)
{
    if (expression.find_first_not_of(" \t") == std::string::npos) {
        throw Error(ErrorKind::InvalidOption,
                    "The size expression is empty; write one in x and y, such as 1 + 0.1*x.");
    }
    if (expression.size() > kLongest) {
        refuse(expression, "it is longer than 4000 characters");
    }
    if (const std::size_t at = findAssignment(expression); at != std::string::npos) {
        refuse(expression,
               "a single = at position " + std::to_string(at) + " (did you mean ==?)");
    }
    try {
        const auto parsed = std::make_shared<Expression>(expression);
        return {"The size expression '" + expression.substr(0, 100) + "'",
                [parsed](Vec2 p) { return (*parsed)(p); }};
    }
    catch (const mu::Parser::exception_type& error) {
        std::string reason = error.GetMsg();
        while (!reason.empty() && (reason.back() == '.' || reason.back() == '!')) {
            reason.pop_back();
        }
        refuse(expression, reason + hintFor(expression));
    }
    catch (const std::string& reason) {
        refuse(expression, reason);
    }
}

} // namespace tessera
