package robotran.cli.messages

import robotran.language.Language
import robotran.language.listed
import robotran.language.withComma
import robotran.simulation.messages.GermanSimulationMessages

/** The messages in German; a random seed is a "Startzahl". */
internal object GermanCommandMessages :
    CommandMessages,
    FileMessages by GermanFileMessages,
    RunMessages by GermanRunMessages,
    RobotMessages by GermanRobotMessages,
    GradeMessages by GermanGradeMessages,
    TowerMessages by GermanTowerMessages,
    WebMessages by GermanWebMessages,
    OutputMessages by GermanOutputMessages

private object GermanFileMessages : FileMessages {
    override val language = Language.GERMAN

    override fun noFile(name: String) = "Es gibt keine Datei $name."

    override fun notAllowed(name: String) = "$name konnte nicht gelesen werden: Das ist nicht erlaubt."

    override fun notText(name: String) = "$name ist kein Text."

    override fun notAJar(name: String) = "$name ist kein Jar, oder es ist beschädigt."

    override fun unreadable(name: String, why: String) = "$name konnte nicht gelesen werden: $why"

    override fun isFolder(name: String) = "$name ist ein Ordner, keine Datei."

    override fun isDevice(name: String) =
        "$name ist keine Datei mit einem Ende, sondern ein Gerät oder eine Pipe, und kann nicht gelesen werden."

    override fun fileTooLarge(name: String, bytes: Long) = "$name ist zu groß: Höchstens $bytes Bytes sind möglich."

    override fun noClassFile(name: String) = "In $name ist keine Klassendatei."

    override fun sourceCounts(name: String) = "In $name zählen die Java-Dateien, nicht die übersetzten Klassen."

    override fun tooManyClasses(name: String, limit: Int) = "$name hat zu viele Klassen: In einen Stein passen $limit."

    override fun classFileTooLarge(name: String, bytes: Int) =
        "$name ist zu groß: Eine Klassendatei kann höchstens $bytes Bytes haben."

    override fun jarTooLarge(name: String, bytes: Int) =
        "$name ist zu groß: Ausgepackt sind höchstens $bytes Bytes möglich."

    override fun tooManyPrograms(limit: Int, given: Int) =
        "In einen Stein passen höchstens $limit Programme, und das sind $given."

    override fun notAProgram(name: String, endings: List<String>) =
        "$name ist kein Programm: Der Name endet nicht mit ${listed(endings, "oder")}, und es ist kein Ordner."

    override fun includesOutside(name: String, line: Int, included: String) =
        "$name:$line: Es bindet $included ein, das nicht im Ordner des Programms ist. Kopiere diese Datei dorthin."

    override fun leadsOutside(name: String) =
        "$name ist eine Verknüpfung mit einer Datei außerhalb des Ordners und wird nicht gelesen."

    override fun theLink() = "Der Link"

    override fun noProgramIn(name: String, robot: String) = "$name enthält kein Programm für den Roboter $robot."

    override fun notRobolang(name: String, ending: String) =
        "$name ist kein Robolang-Programm: Der Name endet nicht mit $ending."

    override fun notToBeChecked(name: String, endings: List<String>) =
        "$name kann nicht geprüft werden: Der Name endet nicht mit ${listed(endings, "oder")}."

    override fun compiled(name: String) =
        "$name ist übersetzt: In einen Link passen Programme, wie sie geschrieben wurden, .robo oder .java."
}

private object GermanRunMessages : RunMessages {
    override fun noMistakes(name: String) = "$name hat keine Fehler."

    override fun warning(line: String) = "$line (ein Hinweis)"

    override fun refusedByBrick(reason: String) = "Ein echter Stein würde dieses Programm ablehnen. $reason"

    override fun imageBuilt(name: String?, bytes: String, left: String): String {
        val sentence =
            name?.let { "$it hat $bytes Bytes." } ?: "Das Programm braucht $bytes Bytes vom Speicher des Steins."
        return "$sentence Auf dem Stein bleiben $left Bytes für Objekte, Arrays und Texte."
    }

    override fun firmwareImageBuilt(name: String?, bytes: String, limit: String) =
        name?.let { "$it ist geschrieben. " }.orEmpty() +
            "Das Programm braucht $bytes der $limit Bytes, die ein Stein für alle Programme und das Datalog hat."

    override fun notFormatted(name: String) = "$name ist nicht ordentlich gesetzt."

    override fun notInUtf8(name: String, encoding: String) = "$name ist in $encoding statt in UTF-8."

    override fun nowInUtf8(name: String, encoding: String) = "$name war in $encoding und ist jetzt in UTF-8."

    override fun needsDesktopApp() = "Fenster und Bilder brauchen die Desktop-App, die ./robotran baut und startet."

    override fun projectHasItsOwn() =
        "Ein Projekt hat seine Welt und seine Programme: --robot passt nur zusammen mit --world dazu."

    override fun firstRobotNamed(name: String) =
        "Der Roboter $name ist der erste: Seine Programme werden ohne --robot genannt."

    override fun romLogLacks(calls: Long) =
        "Im ROM-Protokoll fehlen die ersten $calls Aufrufe: Es behält nur die neuesten."

    override fun nothingStrayed() = "Nichts hat den Roboter abgelenkt."

    override fun ended(seconds: String) = "Das Programm war nach ${withComma(seconds)} s zu Ende."

    override fun timeUp(seconds: String) = "Die Zeit war nach ${withComma(seconds)} s um."

    override fun failed(seconds: String) = "Das Programm konnte nach ${withComma(seconds)} s nicht weiter."

    override fun robotIsAt(x: String, y: String, heading: String, ink: String) =
        "Der Roboter ist bei x ${withComma(x)} cm, y ${withComma(y)} cm, Richtung ${withComma(heading)} Grad; " +
            "er hat ${withComma(ink)} cm gezeichnet."

    override fun goalMet(goal: String) = "${GermanSimulationMessages.met()}: $goal"

    override fun goalNotMet(goal: String, percent: Int) = "${GermanSimulationMessages.notMet()} ($percent %): $goal"

    override fun atTime(seconds: String) = "bei ${withComma(seconds)} s"

    override fun atPlace(x: String, y: String) = "bei x ${withComma(x)} cm, y ${withComma(y)} cm"

    override fun atLine(line: Int) = "in Zeile $line"

    override fun atLineOf(file: String, line: Int) = "in Zeile $line von $file"
}

private object GermanGradeMessages : GradeMessages {
    override fun noGoals(world: String) = "Die Welt $world hat keine Ziele, also gibt es nichts zu bewerten."

    override fun noHandIns() = "In dem, was genannt wurde, sind keine Abgaben."

    override fun pageWithoutPictures() =
        "Die Seite hat keine Bilder: Die brauchen die Desktop-App, die ./robotran baut und startet."

    override fun noRobot(name: String) = "Kein Roboter in dieser Welt heißt $name."

    override fun goalColumns() = listOf("Ziel", "Startzahlen", "schlechtestes")

    override fun programColumns() = listOf("Programm", "geschaffte Startzahlen", "erstes verfehltes Ziel")

    override fun countOf(some: Int, all: Int) = "$some von $all"

    override fun cannotRun() = "Es kann nicht laufen: Es hat Fehler."

    override fun cannotBeUsed() = "Es ist nicht zu gebrauchen."

    override fun numberedLink(number: Int) = "Link $number"

    override fun seeds(first: Int, last: Int) = if (first == last) {
        "Startzahl $first"
    } else {
        "Startzahlen $first bis $last"
    }

    override fun meetsAll(program: String, seeds: String) = "$program schafft alle Ziele mit $seeds."

    override fun meetsSome(program: String, passed: Int, all: Int, seeds: String) =
        "$program schafft alle Ziele mit $passed von $all Startzahlen ($seeds)."

    override fun seedMissed(seed: Int, goal: String?, percent: String) = if (goal == null) {
        "Startzahl $seed: kein Ziel"
    } else {
        "Startzahl $seed: \"$goal\" wurde nicht geschafft ($percent)"
    }

    override fun seedFailed(missed: String, error: String) = "$missed. Das Programm konnte nicht weiter: $error"

    override fun noGoal() = "kein Ziel"

    override fun programFailed(error: String) = "Das Programm konnte nicht weiter: $error"

    override fun moreSeeds(count: Int, seeds: String) = "Und $count mehr: Startzahlen $seeds."

    override fun runsDone(done: Int, all: Int) = "$done von $all Läufen"
}

private object GermanWebMessages : WebMessages {
    override fun notAnAssignment(name: String) =
        "$name ist keine Aufgabe. \"Aufgabe stellen\" in der App macht eine daraus."

    override fun noSuchCourse(name: String, known: List<String>) =
        "Es gibt keinen Kurs, der $name heißt. Es gibt ${listed(known, "und")}."

    override fun isCourse(name: String) = "$name ist ein ganzer Kurs. Nimm eine seiner Aufgaben."

    override fun siteNotBuilt(folder: String) = "In $folder liegt keine gebaute Seite. ./gradlew :webApp:dist baut sie."

    override fun siteNotHere() =
        "Bei diesem Robotran ist keine Webseite dabei. Nimm ./robotran web im Quelltext-Ordner oder nenne einen " +
            "Ordner mit --site."

    override fun portTaken(port: Int) =
        "Port $port lässt sich nicht benutzen, vielleicht weil ein anderes Programm ihn hat. Wähle einen anderen mit " +
            "--port."

    override fun siteServed(address: String) =
        "Robotran ist unter $address zu finden, nur auf diesem Rechner, bis du Strg+C drückst."

    override fun linksStayHere(site: String) =
        "Links, die mit $site beginnen, gehen nur auf diesem Rechner; für andere muss die Seite dort liegen, wo sie " +
            "sie erreichen."
}
