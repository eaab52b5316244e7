// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cmath>
#include <optional>

namespace pixelplumb {

/// Works out a formula with all numbers put in: + − · / ( ) ⌈ ⌉ ⌊ ⌋, decimals and mixed numbers
/// ("-17 3/8"). None where words, names or shortened numbers are left in it.
class FormulaValue {
public:
    static std::optional<double> of(const QString &text)
    {
        FormulaValue value(text);
        const double result = value.sum();
        if (value.m_failed || value.m_place != text.size())
            return std::nullopt;
        return result;
    }

private:
    explicit FormulaValue(const QString &text)
        : m_text(text)
    {
    }

    QChar next() const { return m_place < m_text.size() ? m_text[m_place] : QChar(); }
    bool takes(QChar character)
    {
        if (next() != character)
            return false;
        ++m_place;
        return true;
    }
    void skipBlanks()
    {
        while (next() == u' ')
            ++m_place;
    }

    double sum()
    {
        double value = product();
        for (;;) {
            skipBlanks();
            if (takes(u'+'))
                value += product();
            else if (takes(u'−'))
                value -= product();
            else
                return value;
        }
    }
    double product()
    {
        double value = factor();
        for (;;) {
            if (takes(u'·'))
                value *= factor();
            else if (takes(u'/'))
                value /= factor();
            else
                return value;
        }
    }
    double factor()
    {
        skipBlanks();
        if (takes(u'−'))
            return -factor();
        if (takes(u'('))
            return closed(sum(), u')');
        if (takes(u'⌈'))
            return std::ceil(closed(sum(), u'⌉'));
        if (takes(u'⌊'))
            return std::floor(closed(sum(), u'⌋'));
        return takes(u'½') ? 0.5 : number();
    }
    double closed(double value, QChar bracket)
    {
        m_failed = m_failed || !takes(bracket);
        return value;
    }
    double number()
    {
        const double sign = takes(u'-') ? -1 : 1;
        double value = digits();
        // "17 3/8": a blank and a digit follow the whole.
        if (next() == u' ' && m_place + 1 < m_text.size() && m_text[m_place + 1].isDigit()) {
            ++m_place;
            const double numerator = digits();
            m_failed = m_failed || !takes(u'/');
            value += numerator / digits();
        }
        return sign * value;
    }
    double digits()
    {
        const qsizetype first = m_place;
        while (next().isDigit() || next() == u'.')
            ++m_place;
        bool isNumber = false;
        const double value = m_text.sliced(first, m_place - first).toDouble(&isNumber);
        m_failed = m_failed || !isNumber;
        return value;
    }

    QString m_text;
    qsizetype m_place = 0;
    bool m_failed = false;
};

} // namespace pixelplumb
