// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/spreadsheettext.h"
#include "core/lab/study/labfields.h"
#include "core/lab/study/labfile.h"

namespace pixelplumb {

namespace {

/// Walks the fields of a row in one order, for the header and for every line. Missing parts are
/// walked too, as empty fields.
class CsvLine {
public:
    enum class Kind { Header, Values };

    explicit CsvLine(Kind kind)
        : m_kind(kind)
    {
    }

    QByteArray text() const { return m_fields.join(u',').toUtf8() + '\n'; }

    /// A name, which may come from a results file.
    void add(const QString &name, const QString &value) { put(name, spreadsheetText(value)); }
    void add(const QString &name, bool value) { put(name, QString::number(int(value))); }
    void add(const QString &name, int value) { put(name, QString::number(value)); }
    void add(const QString &name, std::int64_t value) { put(name, QString::number(value)); }
    void add(const QString &name, double value) { put(name, QString::number(value, 'g', 9)); }
    template <class Enum>
    requires std::is_enum_v<Enum>
    void add(const QString &name, Enum value) { add(name, fileWord(nameOf(value))); }
    /// Scenes are too much for a line: they are in the JSON.
    void add(const QString &, const Scene &) { }
    /// Named by operations: plain fields would be numbered.
    void add(const QString &name, const OperationCounts &counts)
    {
        for (const WorkStage stage : allWorkStages) {
            for (const Operation operation : allOperations) {
                add(u"%1.%2 %3"_s.arg(name, fileWord(nameOf(stage)), fileWord(nameOf(operation))),
                    counts.of(stage, operation));
            }
        }
        add(name + u".primitives"_s, counts.primitives);
        add(name + u".spans"_s, counts.spans);
        add(name + u".pixels"_s, counts.pixels);
        add(name + u".refused"_s, counts.refused);
    }
    template <class T, std::size_t count>
    void add(const QString &name, const std::array<T, count> &values)
    {
        for (std::size_t i = 0; i < count; ++i)
            add(u"%1[%2]"_s.arg(name, QString::number(i)), values[i]);
    }
    template <class T>
    void add(const QString &name, const std::optional<T> &value)
    {
        const bool wasMissing = m_isMissing;
        m_isMissing = m_isMissing || !value;
        add(name, value.value_or(T()));
        m_isMissing = wasMissing;
    }
    template <HasFields Part>
    void add(const QString &name, const Part &part)
    {
        const QString prefix = name.isEmpty() ? name : name + u'.';
        eachField(part, [&](const char *field, const auto &value) {
            add(prefix + QLatin1String(field), value);
        });
    }

private:
    void put(const QString &name, const QString &value)
    {
        QString field = m_kind == Kind::Header ? name : m_isMissing ? QString() : value;
        if (field.contains(u',') || field.contains(u'"') || field.contains(u'\n')
            || field.contains(u'\r'))
            field = u'"' + field.replace(u'"', u"\"\""_s) + u'"';
        m_fields.append(field);
    }

    Kind m_kind;
    bool m_isMissing = false;
    QStringList m_fields;
};

CsvLine lineOf(const Study &study, const LabRow &row, CsvLine::Kind kind)
{
    CsvLine line(kind);
    line.add(QString(), row);
    const StudyContender *contender = study.contender(row.contender);
    line.add("kernel", contender ? contender->kernel : kernelOf(row.contender));
    line.add("proved", contender && contender->isProved);
    line.add("nsPerPixel", study.perPixel(row));
    line.add("missesStraight", row.missesStraight());
    return line;
}

} // namespace

QByteArray csvOf(const Study &study)
{
    QByteArray text = lineOf(study, {}, CsvLine::Kind::Header).text();
    for (const LabRow &row : study.rows)
        text += lineOf(study, row, CsvLine::Kind::Values).text();
    return text;
}

QByteArray accuracyCsvOf(const Study &study)
{
    Study accuracy = study;
    for (LabRow &row : accuracy.rows)
        row = row.withoutTimes();
    return csvOf(accuracy);
}

} // namespace pixelplumb
