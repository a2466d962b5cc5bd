// SPDX-License-Identifier: MIT
#include "expression/expression_source.h"

#include "base/error.h"

#include <muParser.h>

#include <memory>
#include <numbers>

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
        return parser_.Eval();
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
    try {
        const auto parsed = std::make_shared<Expression>(expression);
        return {"The size expression '" + expression.substr(0, 100) + "'",
                [parsed](Vec2 p) { return (*parsed)(p); }};
    }
    catch (const mu::Parser::exception_type& error) {
        refuse(expression, error.GetMsg());
    }
    catch (const std::string& reason) {
        refuse(expression, reason);
    }
}

} // namespace tessera
