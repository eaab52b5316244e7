// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/console.h"
#include "core/methods/method.h"
#include "core/scan/choicenames.h"
#include "core/scene/files/filepath.h"
#include "version.h"
#include "widgets/files/scenefiles.h"
#include "widgets/look/corewords.h"
#include "widgets/look/numberformat.h"
#include "widgets/look/paletteswitch.h"
#include "widgets/model/scenedocument.h"
#include "widgets/window/mainwindow.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QFileInfo>
#include <QIcon>
#include <QLocale>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <string_view>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

using namespace pixelplumb;
using namespace Qt::StringLiterals;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(main)
};

template <class Choices>
QString listed(const Choices &choices)
{
    return namesOf(choices).join(u", "_s);
}

struct Options {
    QCommandLineOption palette{u"palette"_s, Words::tr("Colours: light, dark or system."),
                               u"name"_s};
    QCommandLineOption position{u"position"_s,
                                Words::tr("Start with the first <steps> steps done."), u"steps"_s};
    QCommandLineOption column{u"column"_s, Words::tr("Start as column <x> is entered."), u"x"_s};
    QCommandLineOption method{u"method"_s, Words::tr("Draw by this method."), u"name"_s};
    QCommandLineOption arithmetic{
        u"arithmetic"_s,
        Words::tr("Instead of the scene's, one of: %1.").arg(listed(allArithmetics)), u"name"_s};
    QCommandLineOption fillRule{
        u"fill-rule"_s, Words::tr("Instead of the scene's, one of: %1.").arg(listed(allFillRules)),
        u"name"_s};

    QList<QCommandLineOption> all() const
    {
        return {palette, position, column, method, arithmetic, fillRule};
    }
};

/// Ends the program because an argument cannot be valid.
[[noreturn]] void refuse(const QString &what)
{
    cli::sayLine(u"pixelplumb: "_s + what);
    std::exit(int(cli::ExitCode::Usage));
}
[[noreturn]] void refuse(const QString &option, const QString &value, const QString &expected)
{
    refuse(u"--%1 %2: expected %3"_s.arg(option, value, expected));
}

qlonglong numberOf(const QCommandLineParser &parser, const QCommandLineOption &option)
{
    bool isNumber = false;
    const qlonglong number = parser.value(option).toLongLong(&isNumber);
    if (!isNumber)
        refuse(option.names().constFirst(), parser.value(option), u"an integer"_s);
    return number;
}

std::size_t stepsOf(const QCommandLineParser &parser, const Options &options)
{
    const qlonglong steps = numberOf(parser, options.position);
    if (steps < 0)
        refuse(u"position"_s, parser.value(options.position), u"0 or more"_s);
    return std::size_t(steps);
}

/// Replaces the scene's settings by those of the command line; this does not count as a change to
/// save.
void overrideSettings(MainWindow &window, const QCommandLineParser &parser, const Options &options)
{
    Scene scene = window.parts().document->scene();
    if (parser.isSet(options.method)) {
        const QString name = parser.value(options.method);
        if (!methodNamed(name)) {
            QStringList ids;
            for (const Method &method : methods())
                ids += method.id;
            refuse(u"method"_s, name,
                   u"a method that pixelplumb-cli methods lists"_s + cli::suggestion(name, ids));
        }
        scene.method = parser.value(options.method).toStdString();
    }
    if (parser.isSet(options.arithmetic)) {
        const auto arithmetic = arithmeticNamed(parser.value(options.arithmetic).toStdString());
        if (!arithmetic)
            refuse(u"arithmetic"_s, parser.value(options.arithmetic),
                   u"one of "_s + listed(allArithmetics));
        scene.settings.arithmetic = *arithmetic;
    }
    if (parser.isSet(options.fillRule)) {
        const auto rule = fillRuleNamed(parser.value(options.fillRule).toStdString());
        if (!rule)
            refuse(u"fill-rule"_s, parser.value(options.fillRule),
                   u"one of "_s + listed(allFillRules));
        scene.settings.fillRule = *rule;
    }
    if (scene != window.parts().document->scene())
        window.parts().document->reset(scene);
}

void setOpeningPlace(MainWindow &window, const QCommandLineParser &parser, const Options &options,
                     const OpeningPlace &otherwise)
{
    if (parser.isSet(options.position))
        window.setOpeningPlace(stepsOf(parser, options));
    else if (parser.isSet(options.column))
        window.setOpeningPlace(OpeningColumn{numberOf(parser, options.column)});
    else
        window.setOpeningPlace(otherwise);
}

/// Opens what was named. Until then, and beside a class's grades, the first scene is shown: a large
/// file takes long, and may be faulty.
void open(MainWindow &window, const QCommandLineParser &parser, const Options &options)
{
    const auto take = [&window, &parser, &options](const OpeningPlace &place) {
        overrideSettings(window, parser, options);
        setOpeningPlace(window, parser, options, place);
    };
    window.openDefaultScene();
    take(OpeningMoment::HalfDrawn);
    QStringList paths = parser.positionalArguments();
    std::ranges::transform(paths, paths.begin(), filePath);
    if (paths.isEmpty())
        return;
    if (paths.size() > 1 || paths.constFirst().isEmpty())
        refuse(u"“%1”: expected one scene, or one folder of results"_s.arg(paths.constLast()));
    if (QFileInfo(paths.constFirst()).isDir())
        return window.openResults(paths.constFirst());
    if (!window.openScene(paths.constFirst()))
        return;
    const SceneFiles *files = window.parts().files;
    if (files->isLoading())
        QObject::connect(
            files, &SceneFiles::loaded, &window, [take] { take(OpeningMoment::Finished); },
            Qt::SingleShotConnection);
    else
        take(OpeningMoment::Finished);
}

void nameApplication()
{
    QCoreApplication::setOrganizationName(u"Pixelplumb"_s);
    QCoreApplication::setApplicationName(u"pixelplumb"_s);
    QCoreApplication::setApplicationVersion(QStringLiteral(PIXELPLUMB_VERSION));
}

void describe(QCommandLineParser &parser, const Options &options)
{
    parser.setApplicationDescription(Words::tr("See and step through triangle scan conversion."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(u"scene"_s,
                                 Words::tr("A scene file to open, or a folder of results of "
                                           "pixelplumb-cli grade, to look through in Grading."),
                                 u"[scene | results]"_s);
    parser.addOptions(options.all());
}

/// Whether only help or the version is wanted: both work without a display, where a QApplication
/// would end the program.
bool asksForWordsAlone(int argc, char *argv[])
{
    constexpr std::array<std::string_view, 6> words
        = {"--help", "-h", "-?", "--help-all", "--version", "-v"};
    return std::any_of(argv + 1, argv + argc, [&](const char *argument) {
        return std::ranges::find(words, std::string_view(argument)) != words.end();
    });
}

} // namespace

int main(int argc, char *argv[])
{
#if defined(__GLIBC__)
    // The blocks of a recorded run (64 KiB each) return to the system as soon as the run is
    // dropped, instead of piling up in the workers' heaps.
    mallopt(M_MMAP_THRESHOLD, 1 << 16);
#endif
    if (const auto refusal = cli::refusalOfBytes(argc, argv))
        refuse(*refusal);
    const bool isWindowless = asksForWordsAlone(argc, argv);
    const std::unique_ptr<QCoreApplication> application(
        isWindowless ? new QCoreApplication(argc, argv) : new QApplication(argc, argv));
    nameApplication();
    const Translation translation(QLocale::system().uiLanguages());
    keepDecimalPoint();
    const Options options;
    QCommandLineParser parser;
    describe(parser, options);
    if (!parser.parse(QCoreApplication::arguments()))
        refuse(parser.errorText());
    for (const QCommandLineOption &option : options.all()) {
        if (parser.values(option).size() > 1)
            refuse(u"--%1 stands twice; expected it once"_s.arg(option.names().constFirst()));
    }
    parser.process(*application); // prints help and the version, and ends the program
    QApplication::setDesktopFileName(u"org.pixelplumb.Pixelplumb"_s);
    QApplication::setWindowIcon(QIcon(u":/icons/pixelplumb.svg"_s));
    const auto palette = paletteNamed(parser.value(options.palette));
    if (parser.isSet(options.palette) && !palette)
        refuse(u"palette"_s, parser.value(options.palette), u"light, dark or system"_s);

    MainWindow window;
    if (palette)
        window.palettes()->setForThisRun(*palette);
    open(window, parser, options);
    window.show();
    window.greet();
    window.offerRecovery();
    return QApplication::exec();
}
