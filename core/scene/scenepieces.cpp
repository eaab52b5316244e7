// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/scenepieces.h"

namespace pixelplumb {

namespace {

constexpr QByteArrayView primitivesKey = "\"primitives\"";

/// Follows strings and brackets through a JSON text.
class BracketWalk {
public:
    explicit BracketWalk(QByteArrayView text)
        : m_text(text)
    {
    }

    bool isAtEnd() const { return m_position >= m_text.size(); }
    qsizetype position() const { return m_position; }
    int depth() const { return m_depth; }

    /// Goes past one character, or past a whole string.
    void advance()
    {
        switch (m_text[m_position]) {
        case '"':
            skipString();
            return;
        case '{':
        case '[':
            ++m_depth;
            break;
        case '}':
        case ']':
            --m_depth;
            break;
        default:
            break;
        }
        ++m_position;
    }

private:
    void skipString()
    {
        for (++m_position; m_position < m_text.size() && m_text[m_position] != '"'; ++m_position)
            m_position += m_text[m_position] == '\\' ? 1 : 0;
        ++m_position;
    }

    QByteArrayView m_text;
    qsizetype m_position = 0;
    int m_depth = 0;
};

/// Where the value of the scene's "primitives" begins, if that is an array.
std::optional<qsizetype> arrayOfPrimitives(QByteArrayView text)
{
    for (BracketWalk walk(text); !walk.isAtEnd(); walk.advance()) {
        if (walk.depth() != 1 || !text.sliced(walk.position()).startsWith(primitivesKey))
            continue;
        qsizetype place = walk.position() + primitivesKey.size();
        while (place < text.size()
               && (text[place] == ':' || QByteArrayView(" \t\r\n").contains(text[place])))
            ++place;
        if (place < text.size() && text[place] == '[')
            return place;
        return std::nullopt;
    }
    return std::nullopt;
}

} // namespace

std::optional<ScenePieces> piecesOf(const QByteArray &text)
{
    const QByteArrayView view(text);
    const std::optional<qsizetype> array = arrayOfPrimitives(view);
    if (!array)
        return std::nullopt;
    ScenePieces pieces;
    const QByteArrayView content = view.sliced(*array);
    BracketWalk walk(content);
    walk.advance();
    qsizetype first = walk.position();
    while (!walk.isAtEnd() && walk.depth() > 0) {
        const char character = content[walk.position()];
        const bool ends = walk.depth() == 1 && (character == ',' || character == ']');
        if (ends) {
            const QByteArrayView piece = content.sliced(first, walk.position() - first).trimmed();
            if (!piece.isEmpty())
                pieces.primitives.push_back(piece);
            else if (character == ',' || !pieces.primitives.empty())
                return std::nullopt; // an element is missing
        }
        walk.advance();
        if (ends)
            first = walk.position();
    }
    if (walk.depth() != 0 || walk.position() > content.size())
        return std::nullopt;
    pieces.gapAt = *array + 1; // the closing bracket
    pieces.gap = walk.position() - 2;
    pieces.frame = text.first(*array) + "[]" + text.sliced(*array + walk.position());
    return pieces;
}

} // namespace pixelplumb
