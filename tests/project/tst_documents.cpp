// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layer.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>

namespace tst_documents {

using namespace pixelplumb;

namespace {

/// Sources, scripts and documents of the tree, relative to it.
QStringList filesOfTheTree()
{
    QStringList paths = {u"README.md"_s};
    for (const char *folder : {"app", "core", "resources", "tests", "widgets"}) {
        for (const QString &path : filesBelow(QString::fromLatin1(folder), {})) {
            static const QRegularExpression kinds(u"^(h|cpp|md|py|sh|txt|1|)$"_s);
            if (kinds.match(QFileInfo(path).suffix()).hasMatch())
                paths.append(path);
        }
    }
    return paths;
}

/// Whether a test of this name, tst_columnscan, is one of the sources.
bool hasTest(const QString &name) { return filesBelow(u"tests"_s, {name + ".cpp"}).size() == 1; }

/// The text as a person reads it: comments and adjacent literals joined across line breaks.
QString runningText(const QString &path)
{
    QString text = textInTree(path);
    text.replace(QRegularExpression(u"\"\\s*\\n\\s*\""_s), QString());
    text.replace(QRegularExpression(u"\\s*\\n\\s*(///?<?|[*-])?\\s*"_s), u" "_s);
    return text;
}

QStringList captures(const QString &pattern, const QString &text)
{
    QStringList found;
    const QRegularExpression expression(pattern, QRegularExpression::MultilineOption);
    for (auto match = expression.globalMatch(text); match.hasNext();)
        found.append(match.next().captured(1));
    return found;
}

/// The text under each heading of sources.md, by heading.
QMap<QString, QString> sectionsOfTheSources()
{
    QMap<QString, QString> sections;
    for (const QString &section : textInTree("resources/sources.md").split(u"\n## "_s))
        sections.insert(section.section(u'\n', 0, 0), section.section(u'\n', 1));
    return sections;
}

/// A slide's title without quotation marks and without "(2/4)".
QStringList titlesIn(const QString &text)
{
    QStringList titles = captures(u"[\"“]([^\"“”]+)[\"”]"_s, text);
    for (QString &title : titles)
        title.remove(QRegularExpression(u" ?\\(\\d/\\d\\)$"_s));
    titles.removeAll(QString());
    return titles;
}

} // namespace

/// Everything cited can be found: course texts, slides, sections, files, tests.
class TestDocuments : public QObject {
    Q_OBJECT

private slots:
    void everyCitedCourseTextAndSlideStandsInTheSources()
    {
        const QMap<QString, QString> sections = sectionsOfTheSources();
        const QString titles = u"(?:,? (?:and |to )?[\"“][^\"“”]+[\"”])*"_s;
        const QRegularExpression citation(u"((?:[A-Z]\\w+ )+slides|[A-Z]\\w+ \\(Borst\\))("_s
                                          + titles + u')');
        int cited = 0;
        for (const QString &path : filesOfTheTree()) {
            const QString text = runningText(path);
            for (auto match = citation.globalMatch(text); match.hasNext();) {
                const QRegularExpressionMatch found = match.next();
                QString name = found.captured(1);
                name.remove(QRegularExpression(u"^The "_s));
                if (name == QLatin1String("slides"))
                    continue;
                const QString where = path + u": "_s + found.captured();
                QVERIFY2(sections.contains(name), qPrintable(where));
                const QStringList known = titlesIn(sections[name]);
                for (const QString &title : titlesIn(found.captured(2)))
                    QVERIFY2(known.contains(title), qPrintable(where));
                ++cited;
            }
            QVERIFY2(!text.contains(QRegularExpression(u"[Ss]eeds? 00\\d"_s)), qPrintable(path));
        }
        QVERIFY(cited > 100);
    }

    void everyMethodAndLayerCitesACourseTextAndStandsInTheSources()
    {
        const QMap<QString, QString> sections = sectionsOfTheSources();
        const QString text = textInTree("resources/sources.md");
        const auto verify = [&](const QString &id, const QString &source) {
            const bool cites = std::ranges::any_of(
                sections.keys(), [&](const QString &name) { return source.contains(name); });
            QVERIFY2(cites, qPrintable(source));
            QVERIFY2(text.contains(u'`' + id + u'`'),
                     qPrintable(id + u" is not in resources/sources.md"_s));
        };
        for (const Method &method : methods())
            verify(method.id, method.source);
        for (const Layer &layer : layers())
            verify(layer.id, layer.source);
        QStringList names = captures(u"`([a-z][a-z-]+)`"_s, text);
        names.removeOne(u"closed"_s);
        names.removeOne(u"off-screen-point"_s);
        for (const QString &name : names)
            QVERIFY2(methodNamed(name) || layerNamed(name), qPrintable(name));
    }

    void everyCitedSectionOfTheNumericsIsThere()
    {
        const QStringList sections
            = captures(u"^###? (\\d(?:\\.\\d)?) "_s, textInTree("resources/numerics.md"));
        int cited = 0;
        for (const QString &path : filesOfTheTree()) {
            const QString place = u"numerics\\.md`?,((?:(?:,| and| to)? \\d\\.\\d)+)"_s;
            for (const QString &list : captures(place, runningText(path))) {
                for (const QString &section : captures(u"(\\d\\.\\d)"_s, list))
                    QVERIFY2(sections.contains(section), qPrintable(path + u' ' + section));
                ++cited;
            }
        }
        QVERIFY(cited >= 15);
    }

    void everyFileAndTestThatADocumentNamesIsThere()
    {
        const QStringList files = filesOfTheTree();
        QString code;
        QSet<QString> fileNames;
        for (const QString &path : files) {
            fileNames.insert(path.section(u'/', -1));
            if (path.endsWith(QLatin1String(".cpp")) || path.endsWith(QLatin1String(".h")))
                code += textInTree(path);
        }
        for (const QString &path : documents()) {
            const QString text = textInTree(path);
            const QString place
                = u"(?<![\\w/.])((?:app|core|resources|tests|widgets)/[\\w./-]*\\w)"_s;
            for (const QString &named : captures(place, text))
                QVERIFY2(QFileInfo::exists(inTree(named)), qPrintable(path + u' ' + named));
            const QDir folder = QFileInfo(inTree(path)).dir();
            for (const QString &target : captures(u"\\]\\(([^)#:]+)\\)"_s, text))
                QVERIFY2(folder.exists(target), qPrintable(path + u' ' + target));
            for (const QString &file : captures(u"`([\\w-]+\\.(?:h|cpp|md))`"_s, text))
                QVERIFY2(fileNames.contains(file), qPrintable(path + u' ' + file));
            for (const QString &test : captures(u"`(tst_\\w+)`"_s, text))
                QVERIFY2(hasTest(test), qPrintable(path + u' ' + test));
        }
        const QString numerics = textInTree("resources/numerics.md");
        for (const QString &name : captures(u"`([a-z]+[A-Z0-9]\\w+)[`…]"_s, numerics))
            QVERIFY2(code.contains(name), qPrintable(name));
    }

    void everyLibraryFolderIsDocumented()
    {
        const QString text = textInTree("resources/extending.md");
        for (const char *library : {"core", "widgets"}) {
            const QStringList folders
                = QDir(inTree(library)).entryList(QDir::Dirs | QDir::NoDotAndDotDot);
            QVERIFY(folders.size() > 5);
            for (const QString &folder : folders)
                QVERIFY2(text.contains(u'`' + folder + u'`'), qPrintable(folder));
        }
    }

    void theReadmeIsAPage()
    {
        const qsizetype bytes = textInTree("README.md").toUtf8().size();
        QVERIFY2(bytes > 1000 && bytes <= 6 * 1024, qPrintable(QString::number(bytes)));
    }

    void theEveningsReadingHasAtMost2500Lines()
    {
        const QStringList files
            = captures(u"^\\| `([\\w/]+\\.(?:h|cpp))` \\|"_s, textInTree("resources/extending.md"));
        QVERIFY(files.size() > 10);
        qsizetype lines = 0;
        for (const QString &file : files) {
            const QString text = textInTree(file);
            QVERIFY2(!text.isEmpty(), qPrintable(file));
            lines += text.count(u'\n');
        }
        QVERIFY2(lines <= 2500, qPrintable(QString::number(lines)));
    }
};

PIXELPLUMB_TEST(TestDocuments)

} // namespace tst_documents

#include "tst_documents.moc"
