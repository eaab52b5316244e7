// SPDX-License-Identifier: GPL-3.0-or-later

// A "%1" in a text is replaced by the next QString::arg of a chain. So only the last .arg call of a
// chain takes texts, all at once; earlier calls take numbers.

#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>
#include <tuple>

namespace tst_textarguments {

using namespace Qt::StringLiterals;

namespace {

/// Folders that use only the program's own words; no outside names pass through them.
const QStringList &roomsOfOwnWords()
{
    static const QStringList rooms
        = {"core/methods/", "core/layers/",  "core/runs/",       "core/plan/",
           "core/shade/",   "core/measure/", "widgets/inspect/", "widgets/space/"};
    return rooms;
}

/// The arguments between the brackets that open at a position, and the position after them.
std::pair<QString, qsizetype> bracketed(const QString &text, qsizetype open)
{
    int depth = 0;
    bool isQuoted = false;
    for (qsizetype place = open; place < text.size(); ++place) {
        const QChar character = text[place];
        if (isQuoted) {
            place += character == u'\\' ? 1 : 0;
            isQuoted = character != u'\"';
        } else if (character == u'\"') {
            isQuoted = true;
        } else if (character == u'(') {
            ++depth;
        } else if (character == u')' && --depth == 0) {
            return {text.sliced(open + 1, place - open - 1).simplified(), place + 1};
        }
    }
    return {{}, text.size()};
}

/// Whether an expression looks like a text: by its last name, or by a call.
bool looksLikeText(const QString &expression)
{
    static const QRegularExpression literal(
        u"(QStringLiteral|QLatin1String|tr)\\(\\s*(\"([^\"\\\\]|\\\\.)*\"\\s*)+\\)"_s);
    static const QRegularExpression last(
        u"(path|name|title|text|folder|file|word|what|where|kind|message|heading|"
        "suffix|key|drawnBy|told|why|reason|fault|front\\(\\)|value|argument)"
        "(\\([^()]*\\))?$"_s,
        QRegularExpression::CaseInsensitiveOption);
    static const QRegularExpression call(
        u"\\b(QString::from|toString|join\\(|fileName|argument\\(|value\\(|tr\\()"_s);
    const QString shown = QString(expression).remove(literal);
    return last.match(shown).hasMatch() || call.match(shown).hasMatch();
}

/// The first text in a chain of .arg that is not in its last call; empty if there is none.
QStringList garbledIn(const QString &text)
{
    const QString call = u".arg("_s;
    QStringList found;
    for (qsizetype place = text.indexOf(call); place >= 0; place = text.indexOf(call, place)) {
        QString arguments;
        while (QStringView(text).sliced(place).startsWith(call)) {
            if (looksLikeText(arguments))
                found += arguments;
            std::tie(arguments, place) = bracketed(text, place + call.size() - 1);
            while (place < text.size() && text[place].isSpace())
                ++place;
        }
    }
    return found;
}

} // namespace

class TestTextArguments : public QObject {
    Q_OBJECT

private slots:
    void noTextTakesThePlaceOfTheNext()
    {
        QStringList complaints;
        int read = 0;
        for (const char *library : {"app", "core", "widgets"}) {
            const QString root = pixelplumb::inTree(QString()) + u'/';
            QDirIterator sources(root + QLatin1String(library), {"*.cpp", "*.h"}, QDir::Files,
                                 QDirIterator::Subdirectories);
            while (sources.hasNext()) {
                const QString path = sources.next().sliced(root.size());
                if (std::ranges::any_of(roomsOfOwnWords(),
                                        [&](const QString &room) { return path.startsWith(room); }))
                    continue;
                QFile file(root + path);
                QVERIFY(file.open(QIODevice::ReadOnly));
                ++read;
                for (const QString &found : garbledIn(QString::fromUtf8(file.readAll())))
                    complaints += path + u": .arg("_s + found + u')';
            }
        }
        QVERIFY(read > 200);
        QVERIFY2(complaints.isEmpty(), qPrintable(complaints.join(u'\n')));
    }

    void whatIsGarbledIsFound_data()
    {
        QTest::addColumn<QString>("source");
        QTest::addColumn<bool>("isGarbled");
        const auto row = [](const char *source, bool isGarbled) {
            QTest::newRow(source) << QString::fromUtf8(source) << isGarbled;
        };
        row("s.arg(path).arg(count)", true);
        row("s.arg(path)\n                .arg(count)", true);
        row("s.arg(n).arg(QFileInfo(path).fileName()).arg(m)", true);
        row("s.arg(line.argument(0)).arg(m)", true);
        row("s.arg(QString::fromUtf8(word->left(20)), kind).arg(most)", true);
        row("s.arg(path, QString::number(count))", false);
        row("s.arg(size.width()).arg(size.height())", false);
        row("s.arg(n).arg(path, name)", false);
        row("s.arg(n == 1 ? QStringLiteral(\"a (file)\") : QStringLiteral(\"b\")).arg(m)", false);
    }
    void whatIsGarbledIsFound()
    {
        QFETCH(QString, source);
        QFETCH(bool, isGarbled);
        QCOMPARE(!garbledIn(source).isEmpty(), isGarbled);
    }
};

PIXELPLUMB_TEST(TestTextArguments)

} // namespace tst_textarguments

#include "tst_textarguments.moc"
