// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/agreement.h"
#include "core/frame/difference.h"
#include "core/grade/class/gradereport.h"
#include "core/grade/pictures/picturediff.h"
#include "core/lab/counting/operation.h"
#include "core/lab/study/pareto.h"
#include "core/layers/layer.h"
#include "core/methods/method.h"
#include "core/runs/explain/formulaexplanation.h"
#include "core/runs/scenerun.h"
#include "core/runs/tracedscene.h"
#include "core/scan/choicenames.h"
#include "core/scene/appearancenames.h"
#include "core/scene/scenefile.h"
#include "core/space/surfaces.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/translationfile.h"
#include "widgets/look/corewords.h"

#include <QTest>
#include <QtWidgets>

#include <span>

namespace tst_translations {

using namespace pixelplumb;

namespace {

const QString sources = resource(u"/.."_s);
const QString english = u"pixelplumb_en.ts"_s;

/// The command that updates the files from the sources.
const QString mending = u"cmake --build build/release --target translations"_s;

/// The texts that lupdate finds in the sources, as an untranslated file has them: all texts or, as
/// for English, only those that depend on a number.
QList<TranslatedText> textsInTheSources(const QStringList &options = {})
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(u"found.ts"_s);
    QProcess lupdate;
    lupdate.setWorkingDirectory(sources);
    lupdate.start(QStringLiteral(PIXELPLUMB_LUPDATE),
                  QStringList{"-silent", "-I", ".", "-no-obsolete", "-locations", "none", "widgets",
                              "app", "core", "-target-language", "de"}
                      + options + QStringList{"-ts", file});
    if (!lupdate.waitForFinished(120000))
        return {};
    if (const QByteArray told = lupdate.readAllStandardError(); !told.isEmpty())
        qWarning("%s", told.constData()); // a class without Q_OBJECT, whose texts are not found
    return textsOf(file);
}

QStringList namesOf(const QList<TranslatedText> &texts)
{
    QStringList names;
    for (const TranslatedText &text : texts)
        names += text.name();
    names.sort();
    return names;
}

QString firstNotIn(const QStringList &some, const QStringList &others)
{
    const QSet<QString> known(others.begin(), others.end());
    for (const QString &each : some) {
        if (!known.contains(each))
            return each;
    }
    return {};
}

QStringList matchesIn(const QString &text, const QString &pattern)
{
    QStringList found;
    const QRegularExpression expression(pattern);
    for (auto match = expression.globalMatch(text); match.hasNext();)
        found += match.next().captured();
    found.sort();
    return found;
}

/// The placeholders for later arguments; %n may be a word in the singular: "once".
QStringList placeholdersIn(const QString &text) { return matchesIn(text, u"%(L?[1-9]|[vm])"_s); }

QStringList tagsIn(const QString &text) { return matchesIn(text, u"</?[a-z][^>]*>"_s); }

bool hasMnemonic(const QString &text) { return !matchesIn(text, "&\\w").isEmpty(); }

/// The punctuation: a dialog follows, a value follows, a sentence ends, a number comes before.
QString edgesOf(const QString &text)
{
    QString edges;
    for (const char *end : {"…", ":", ".", "?", "!", " "}) {
        if (text.endsWith(QString::fromUtf8(end)))
            edges += QString::fromUtf8(end);
    }
    return text.startsWith(u' ') ? u' ' + edges : edges;
}

/// What is wrong with a form; empty if nothing is.
QString faultOf(const TranslatedText &text, const QString &form)
{
    if (form.isEmpty())
        return u"is empty"_s;
    if (placeholdersIn(form) != placeholdersIn(text.source))
        return u"has other placeholders"_s;
    if (tagsIn(form) != tagsIn(text.source))
        return u"has other tags"_s;
    if (edgesOf(form) != edgesOf(text.source))
        return u"begins or ends otherwise"_s;
    if (form.count(u'\n') != text.source.count(u'\n'))
        return u"has other lines"_s;
    if (hasMnemonic(form) != hasMnemonic(text.source))
        return u"has a mnemonic alone, or none"_s;
    return {};
}

QString text(const QString &name) { return name; }
QString text(std::string_view name) { return nameText(name); }

/// The names in core's lists, except those of number formats, such as float32.
QStringList namesOfCore()
{
    QStringList names;
    const auto append = [&names](const auto &choices) {
        for (const auto choice : choices)
            names += text(nameOf(choice));
    };
    append(std::array{PrimitiveKind::Triangle, PrimitiveKind::Point, PrimitiveKind::Line,
                      PrimitiveKind::Circle, PrimitiveKind::Ellipse, PrimitiveKind::Bezier,
                      PrimitiveKind::Polygon, PrimitiveKind::Text});
    append(allSolidKinds);
    append(allSurfaces);
    append(allEffects);
    append(std::span(allDifferences).subspan(1)); // no difference is not shown
    append(allGradeVerdicts);
    append(allDisagreements);
    append(allOperations);
    append(allFillRules);
    append(allByteRoundings);
    names += text(nameOf(Arithmetic::Exact));
    for (const Method &method : methods())
        names += titleOf(method.family);
    for (const Layer &layer : layers())
        names += layer.title;
    for (const ErrorAxis &axis : errorAxes())
        names += QString::fromUtf8(axis.title);
    return names;
}

} // namespace

/// The files of the window's languages, and which of them is used.
class TestTranslations : public QObject {
    Q_OBJECT

private slots:
    void everyTextIsTranslated_data() { addFiles(); }
    void everyTextIsTranslated()
    {
        QFETCH(QString, file);
        const QList<TranslatedText> texts = textsOf(file);

        QVERIFY(!texts.empty());
        for (const TranslatedText &text : texts) {
            QVERIFY2(text.state.isEmpty(), qPrintable(text.name() + " is " + text.state));
            for (const QString &form : text.forms) {
                const QString fault = faultOf(text, form);
                QVERIFY2(fault.isEmpty(), qPrintable(text.name() + "\n“" + form + "” " + fault));
            }
        }
    }

    void whatCountsSaysTheNumberOfManyThings_data() { addFiles(); }
    void whatCountsSaysTheNumberOfManyThings()
    {
        QFETCH(QString, file);

        for (const TranslatedText &text : textsOf(file)) {
            if (!text.counts)
                continue;
            QVERIFY2(text.forms.size() >= 2, qPrintable(text.name()));
            QVERIFY2(text.forms.back().contains("%n") == text.source.contains("%n"),
                     qPrintable(text.name()));
        }
    }

    void theFilesAreInStepWithTheSources_data() { addFiles(); }
    void theFilesAreInStepWithTheSources()
    {
        QFETCH(QString, file);
        const bool isEnglish = QFileInfo(file).fileName() == english;
        const QStringList found
            = namesOf(textsInTheSources(isEnglish ? QStringList("-pluralonly") : QStringList()));
        const QStringList held = namesOf(textsOf(file));
        QVERIFY(!found.empty());

        const QString missing = firstNotIn(found, held);
        QVERIFY2(missing.isEmpty(),
                 qPrintable("not in the file: " + missing + "\nThen: " + mending));
        const QString left = firstNotIn(held, found);
        QVERIFY2(left.isEmpty(),
                 qPrintable("no longer in the sources: " + left + "\nThen: " + mending));
    }

    void theFirstTranslatedLanguageIsUsed_data()
    {
        QTest::addColumn<QStringList>("wanted");
        QTest::addColumn<QString>("taken");
        QTest::newRow("German of Austria") << QStringList{"de-AT"} << "de";
        QTest::newRow("as a locale is written") << QStringList{"de_DE"} << "de";
        QTest::newRow("the second, where the first has no file") << QStringList{"xx", "de"} << "de";
        QTest::newRow("English before German") << QStringList{"en-GB", "de"} << "en";
        QTest::newRow("the computer's language") << QStringList{"C"} << "en";
        QTest::newRow("none") << QStringList{} << "en";
    }
    void theFirstTranslatedLanguageIsUsed()
    {
        QFETCH(QStringList, wanted);

        const Translation translation(wanted);

        QTEST(translation.language(), "taken");
    }

    void aWalksStepsAreToldInGermanAsAWhole_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<int>("rule");
        for (const char *method : {"column-scan", "row-walk"})
            for (const FillRule rule : {FillRule::Closed, FillRule::HalfOpenColumn, FillRule::Open})
                QTest::addRow("%s %s", method, nameOf(rule).data()) << QString(method) << int(rule);
    }
    void aWalksStepsAreToldInGermanAsAWhole()
    {
        QFETCH(QString, method);
        QFETCH(int, rule);
        const Translation german({"de"});
        for (const char *name : {"default", "ties-at-tenths", "vertical-edges", "shared-edge"}) {
            Scene scene = readSceneFile(resource(u"/scenes/%1.json"_s.arg(name)))->scene;
            scene.method = method.toStdString();
            scene.settings = ScanSettings();
            scene.settings.fillRule = FillRule(rule);
            if (!objectionTo(scene).isEmpty())
                continue;
            const auto traced = traceScene(scene);
            for (std::size_t step = 0; step < traced->trace->stepCount(); ++step) {
                const Explanation told = explainStep(*traced, step);
                for (const QString &original : {told.sentence, told.event}) {
                    const QString shown = coreSentences(original);
                    QVERIFY2(original.isEmpty() || !shown.contains(original), qPrintable(original));
                }
            }
            for (const NumberDescription &number : traced->trace->numbers().span) {
                const bool isWord = !matchesIn(number.title, "(?<![A-Za-z_])[a-z]{3,}").isEmpty();
                QVERIFY2(!isWord || coreWord(number.title) != number.title,
                         qPrintable(number.title));
            }
        }
    }

    void whatHasNoTranslationSaysThatItIsEnglish()
    {
        const QString unknown = u"It covers no sample. It is of another kind."_s;
        QCOMPARE(coreSentences(unknown), unknown);
        const Translation german({"de"});
        QCOMPARE(coreSentences(unknown), u"Auf Englisch: "_s + unknown);
        QCOMPARE(coreSentences(u"Nothing is drawn. "_s + unknown),
                 u"Auf Englisch: Nothing is drawn. "_s + unknown);
        QCOMPARE(coreSentences({}), QString());
    }

    void aMixedNumberIsOneNumber()
    {
        const Translation german({"de"});
        QCOMPARE(coreSentences(u"y_B = 7 53/54 and y_T = −43 31/63 cover the rows 8 to 43."_s),
                 u"y_B = 7 53/54 und y_T = −43 31/63 bedecken die Zeilen 8 bis 43."_s);
    }

    void qtsOwnWordsAreInTheSameLanguage()
    {
        const auto cancel = [] {
            const QDialogButtonBox box(QDialogButtonBox::Cancel);
            return box.button(QDialogButtonBox::Cancel)->text().remove(u'&');
        };
        QCOMPARE(cancel(), "Cancel");
        {
            const Translation german({"de"});
            QCOMPARE(cancel(), "Abbrechen");
        }
        QCOMPARE(cancel(), "Cancel");
    }

    void namesOfCoreAreTranslatedAndKeepTheirNumbers()
    {
        const Translation german({"de"});

        QCOMPARE(coreWord(u"triangle"_s), "Dreieck");
        QCOMPARE(coreWord(u"Column −3, second half"_s), "Spalte −3, zweite Hälfte");
        QCOMPARE(coreWords("plain kernel 3.02 ns a pixel · about 9 s", " · "),
                 "einfach 3.02 ns je Pixel · etwa 9 s");
        QCOMPARE(coreWord(u"of no 12 translation"_s), "of no 12 translation");
    }

    void everyNameOfCoreThatTheWindowShowsIsInTheFiles_data() { addFiles(); }
    void everyNameOfCoreThatTheWindowShowsIsInTheFiles()
    {
        QFETCH(QString, file);
        if (QFileInfo(file).fileName() == english)
            return;
        QSet<QString> known;
        for (const TranslatedText &text : textsOf(file)) {
            if (text.context == u"core"_s)
                known += text.source;
        }

        const QString missing = firstNotIn(namesOfCore(), {known.begin(), known.end()});
        QVERIFY2(missing.isEmpty(), qPrintable("mark it by QT_TRANSLATE_NOOP: " + missing));
    }

    void everyMethodsTitleAndSummaryAreTranslated_data() { addFiles(); }
    void everyMethodsTitleAndSummaryAreTranslated()
    {
        QFETCH(QString, file);
        if (QFileInfo(file).fileName() == english)
            return;
        QSet<QString> known;
        for (const TranslatedText &text : textsOf(file)) {
            if (text.context == u"core"_s)
                known += text.source;
        }
        const Translation translation({QFileInfo(file).baseName().section(u'_', 1)});
        for (const Method &method : methods()) {
            QVERIFY2(known.contains(method.title), qPrintable(method.title));
            QVERIFY2(methodSummary(method) != method.summary, qPrintable(method.id));
        }
        QVERIFY(methodTitle(methods().front()) != methods().front().title);
    }

private:
    void addFiles()
    {
        QTest::addColumn<QString>("file");
        for (const QString &path : translationFiles())
            QTest::newRow(qPrintable(QFileInfo(path).baseName())) << path;
    }
};

PIXELPLUMB_TEST(TestTranslations)

} // namespace tst_translations

#include "tst_translations.moc"
