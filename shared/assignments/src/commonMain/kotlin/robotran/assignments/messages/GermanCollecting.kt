package robotran.assignments.messages

import robotran.language.listed

internal object GermanCollectingMessages : CollectingMessages {
    override fun notText(file: String) = "$file ist kein Text."

    override fun tooLarge(file: String, bytes: Int) = "$file ist zu groß: Höchstens $bytes Byte gehen."

    override fun programTooLong(file: String, characters: Int) =
        "$file ist zu lang: Ein Programm darf höchstens $characters Zeichen haben."

    override fun brokenZip(file: String) = "$file ist beschädigt oder gar keine Zip-Datei."

    override fun zip64(file: String) = "$file ist eine Zip-Datei der großen Art (Zip64), die nicht gelesen werden kann."

    override fun encrypted(file: String) = "$file hat ein Passwort."

    override fun unknownCompression(file: String) = "$file ist so gepackt, dass man es nicht lesen kann."

    override fun zipTooDeep(file: String, depth: Int) =
        "$file steckt in zu vielen Zip-Dateien: Höchstens $depth dürfen ineinander stecken."

    override fun zipTooLarge(file: String, bytes: Int) = "$file wird zu groß: Entpackt gehen höchstens $bytes Byte."

    override fun tooManyEntries(file: String, limit: Int) = "$file hat zu viele Dateien: Höchstens $limit gehen."

    override fun nothingUsable() = "Darin ist kein Programm, kein Projekt und kein Link."

    override fun noProgram(robot: String) = "Für den Roboter $robot ist kein Programm darin."

    override fun onlyWorld() = "Das ist ein Link zu einer Welt, ohne Programm."

    override fun onlyCourse() = "Das ist ein Link zu einem Kurs, ohne Programm."

    override fun tooManyPrograms(count: Int, limit: Int) =
        "Es sind $count Programme, aber in einen Stein passen nur $limit."

    override fun others() = "Andere"

    override fun leftOut(count: Int, limit: Int) =
        "$count weitere fehlen: Höchstens $limit Abgaben kann man zusammen ansehen."

    override fun linkIn(file: String, line: Int) = "$file, Zeile $line"

    override fun isAssignment(file: String) = "$file ist die Aufgabe selbst, keine Abgabe."

    override fun isFeedback(file: String) = "$file ist eine Rückmeldung, keine Abgabe."

    override fun pastedLink(number: Int) = "Eingefügter Link $number"

    override fun changed() = "Die Datei wurde nach dem Abgeben geändert, oder sie ist beschädigt."

    override fun otherAssignment(title: String) = "Es wurde für eine andere Aufgabe abgegeben: $title."

    override fun worldChanged() =
        "Die Welt wurde geändert, was die Aufgabe nicht erlaubt. Bewertet wurde in der Welt der Aufgabe."

    override fun ownWorld() =
        "Die Welt wurde geändert, was die Aufgabe erlaubt. Bewertet wurde trotzdem in der Welt der Aufgabe."

    override fun unchanged() = "An den Programmen wurde nichts geändert."

    override fun sameName(count: Int, file: String) = "$count Abgaben haben diesen Namen. Diese ist aus $file."

    override fun languageNotAllowed(program: String) = "$program ist in einer Sprache, die die Aufgabe nicht erlaubt."

    override fun wordsNotAllowed(words: List<String>) =
        "Es benutzt Wörter, die die Aufgabe nicht erlaubt: ${listed(words, "und")}."

    override fun olderLeftOut(count: Int) = if (count == 1) {
        "Eine weitere Abgabe derselben Person zählt nicht: Sie ist älter."
    } else {
        "$count weitere Abgaben derselben Person zählen nicht: Sie sind älter."
    }
}
