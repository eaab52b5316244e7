// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/text/byteordermark.h"
#include "core/scene/text/jsonfault.h"
#include "core/scene/text/jsontext.h"

#include <rapidjson/memorystream.h>
#include <rapidjson/reader.h>

#include <limits>
#include <set>
#include <string>

namespace pixelplumb {

namespace {

constexpr std::size_t deepestNesting = 1024;
constexpr std::size_t mostValues = std::size_t(1) << 24; ///< kept: 256 MiB
constexpr unsigned flags = rapidjson::kParseValidateEncodingFlag;

/// Records where values stand while RapidJSON parses the text.
class Collector : public rapidjson::BaseReaderHandler<rapidjson::UTF8<>, Collector> {
public:
    Collector(const rapidjson::MemoryStream &stream, JsonText &json, QByteArrayView folded)
        : m_stream(stream)
        , m_json(json)
        , m_folded(folded)
    {
    }

    /// A fault that RapidJSON does not detect: it ends the parsing, or is reported for a text that
    /// is otherwise JSON.
    std::optional<JsonFault> fault;

    // RapidJSON's events, with its names.
    bool Default() // a number or a word
    {
        const auto isInside = [](char byte) {
            return byte == '-' || byte == '+' || byte == '.' || (byte >= '0' && byte <= '9')
                || (byte >= 'A' && byte <= 'Z') || (byte >= 'a' && byte <= 'z');
        };
        const char *first = m_stream.src_;
        while (first > m_stream.begin_ && isInside(first[-1]))
            --first;
        return takeScalar(first, kindOf(*first));
    }
    bool String(const char *text, rapidjson::SizeType length, bool /*copy*/)
    {
        return takeScalar(firstOfString(), JsonKind::String) && isText(text, length);
    }
    bool Key(const char *text, rapidjson::SizeType length, bool /*copy*/)
    {
        const auto offset = quint32(firstOfString() - m_stream.begin_);
        m_open.back().key = {offset, end() - offset, place() + 1, JsonKind::String};
        if (!keep(m_open.back().key))
            return false;
        if (!m_keys[m_open.size() - 1].emplace(text, length).second)
            m_hasRepeatedKey = !fault;
        return isText(text, length);
    }
    bool StartObject()
    {
        if (m_keys.size() <= m_open.size())
            m_keys.resize(m_open.size() + 1);
        m_keys[m_open.size()].clear();
        return open(JsonKind::Object);
    }
    bool StartArray() { return open(JsonKind::Array); }
    bool EndObject(rapidjson::SizeType members) { return close(members); }
    bool EndArray(rapidjson::SizeType elements) { return close(elements); }

private:
    struct Open {
        JsonKind kind;
        quint32 place; ///< in the list of values
        bool isFolded = false; ///< its elements are folded
        qsizetype children = 0; ///< begun so far
        JsonValue key = {}; ///< of the last child
    };

    static JsonKind kindOf(char first)
    {
        switch (first) {
        case 'n':
            return JsonKind::Null;
        case 'f':
            return JsonKind::False;
        case 't':
            return JsonKind::True;
        default:
            return JsonKind::Number;
        }
    }

    quint32 place() const { return quint32(m_json.values.size()); }
    quint32 end() const { return quint32(m_stream.src_ - m_stream.begin_); }
    /// The opening quote of the last string; every other quote in it has a backslash before it.
    const char *firstOfString() const
    {
        const char *quote = m_stream.src_ - 2;
        while (*quote != '"' || (quote > m_stream.begin_ && quote[-1] == '\\'))
            --quote;
        return quote;
    }
    /// Whether the current values are recorded: not inside folded elements.
    bool isKept() const { return m_open.size() < 3 || !m_open[1].isFolded; }

    bool isText(const char *text, rapidjson::SizeType length)
    {
        const QByteArrayView view(text, length);
        if (view.isValidUtf8())
            return true;
        // RapidJSON accepts the second half of a surrogate pair without the first.
        fault = JsonFault{quint32(firstOfString() - m_stream.begin_), {}, {}, wholeCharacters()};
        return false;
    }
    void begin(quint32 offset)
    {
        if (!m_open.empty())
            ++m_open.back().children;
        if (m_open.size() == 2)
            m_inElement = 0;
        if (m_hasRepeatedKey) {
            m_hasRepeatedKey = false;
            fault = JsonFault{offset, openPath(), "the key is there twice", "every key once"};
        }
    }
    bool keep(const JsonValue &value)
    {
        const std::size_t before = isKept() ? m_json.values.size() : m_inElement++;
        if (before >= mostValues) {
            fault = JsonFault{
                value.offset, openPath(), "a value too many",
                u"at most %1 in a file without primitives, or in one primitive"_s.arg(mostValues)};
            return false;
        }
        if (isKept())
            m_json.values.push_back(value);
        return true;
    }
    bool takeScalar(const char *first, JsonKind kind)
    {
        const auto offset = quint32(first - m_stream.begin_);
        begin(offset);
        return keep({offset, end() - offset, place() + 1, kind});
    }
    bool open(JsonKind kind)
    {
        const quint32 offset = end() - 1;
        begin(offset);
        if (m_open.size() >= deepestNesting) {
            fault = JsonFault{offset, {}, {}, u"at most %1 levels"_s.arg(deepestNesting)};
            return false;
        }
        const bool isFolded = m_open.size() == 1 && kind == JsonKind::Array && !m_folded.isEmpty()
            && m_open[0].kind == JsonKind::Object
            && m_json.isString(m_json.values.back(), QAnyStringView(QUtf8StringView(m_folded)));
        const quint32 own = place();
        if (!keep({offset, 0, own + 1, kind}))
            return false;
        m_open.push_back({kind, own, isFolded});
        return true;
    }
    bool close(rapidjson::SizeType size)
    {
        const Open closed = m_open.back();
        m_open.pop_back();
        if (isKept()) {
            m_json.values[closed.place].size = size;
            m_json.values[closed.place].next = place();
        }
        return true;
    }
    /// The path of the value that begins.
    QString openPath() const
    {
        QString path = m_json.path;
        for (const Open &open : m_open) {
            path = open.kind == JsonKind::Array ? elementPath(path, open.children - 1)
                                                : memberPath(path, m_json.string(open.key));
        }
        return path;
    }

    const rapidjson::MemoryStream &m_stream;
    JsonText &m_json;
    QByteArrayView m_folded;
    std::vector<Open> m_open;
    std::vector<std::set<std::string, std::less<>>> m_keys; ///< of the open objects, by depth
    std::size_t m_inElement = 0; ///< values of the current element, where elements are folded
    bool m_hasRepeatedKey = false;
};

/// RapidJSON reports the first wrong letter of an invalid word; this finds the word's start.
std::size_t firstOfWord(const QByteArray &text, std::size_t offset)
{
    while (offset > 0 && text[qsizetype(offset) - 1] >= 'a' && text[qsizetype(offset) - 1] <= 'z')
        --offset;
    return offset;
}

} // namespace

Result<JsonText> parseJson(const QByteArray &text, QByteArrayView folded)
{
    const auto size = std::size_t(text.size());
    if (size > std::numeric_limits<quint32>::max())
        return InputError{{}, "more than 4 GiB", {}};
    if (isUtf16(text))
        return InputError{{}, "text in UTF-16", "UTF-8"};
    rapidjson::MemoryStream stream(text.constData(), size);
    if (text.startsWith(byteOrderMark))
        stream.src_ += byteOrderMark.size();
    Result<JsonText> json = JsonText{text, {}, {}};
    Collector collector(stream, *json, folded);
    rapidjson::Reader reader;
    const rapidjson::ParseResult parsed = reader.Parse<flags>(stream, collector);
    if (parsed.Code() == rapidjson::kParseErrorDocumentEmpty && stream.Tell() == size)
        return InputError{{}, "the input is empty", "JSON"};
    std::optional<JsonFault> fault = collector.fault;
    if (parsed.IsError() && parsed.Code() != rapidjson::kParseErrorTermination) {
        const auto offset = parsed.Code() == rapidjson::kParseErrorValueInvalid
            ? firstOfWord(text, parsed.Offset())
            : parsed.Offset();
        const char found = offset < size ? text[qsizetype(offset)] : '\0';
        fault = JsonFault{quint32(offset),
                          {},
                          {},
                          json->values.empty() ? u"JSON"_s : expectedAt(parsed.Code(), found)};
    } else if (stream.Tell() < size && !parsed.IsError()) { // RapidJSON takes a byte 0 for the end
        fault = JsonFault{quint32(stream.Tell()), {}, {}, "the text's end"};
    }
    if (!fault)
        return json;
    return InputError{placeOf(text, fault->offset, fault->path),
                      fault->found.isEmpty() ? foundAt(text, fault->offset) : fault->found,
                      fault->expected};
}

JsonText unfolded(const JsonText &whole, quint32 offset, const QString &path, QByteArrayView folded)
{
    JsonText json{whole.text, path, {}};
    rapidjson::MemoryStream stream(whole.text.constData(), std::size_t(whole.text.size()));
    stream.src_ += offset;
    Collector collector(stream, json, folded);
    rapidjson::Reader().Parse<flags | rapidjson::kParseStopWhenDoneFlag>(stream, collector);
    return json;
}

QString JsonText::string(const JsonValue &string) const
{
    struct Decoder : rapidjson::BaseReaderHandler<rapidjson::UTF8<>, Decoder> {
        QString decoded;
        bool String(const char *utf8, rapidjson::SizeType length, bool /*copy*/)
        {
            decoded = QString::fromUtf8(utf8, qsizetype(length));
            return true;
        }
    };
    const QByteArrayView token = written(string);
    if (!token.contains('\\'))
        return QString::fromUtf8(token.sliced(1, token.size() - 2));
    rapidjson::MemoryStream stream(token.data(), std::size_t(token.size()));
    Decoder decoder;
    rapidjson::Reader().Parse(stream, decoder);
    return decoder.decoded;
}

} // namespace pixelplumb
