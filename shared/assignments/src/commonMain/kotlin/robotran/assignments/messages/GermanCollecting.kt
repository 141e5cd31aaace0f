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

    override fun otherAssignment(title: String) = "Es wurde für eine andere Aufgabe abgegeben: $title."

    override fun noTask() = "Nichts sagt, zu welcher Aufgabe des Kurses es gehört. " +
        "Schreib den Namen der Aufgabe in den Namen der Datei oder eines Ordners."

    override fun emptyFolder() = "Der Ordner ist leer."

    override fun onlyCompiled() = "Darin sind nur übersetzte Klassen. Frag nach den Java-Dateien."

    override fun changed() = "Die Datei wurde nach dem Abgeben geändert, oder sie ist beschädigt."

    override fun worldChanged() =
        "Die Welt wurde geändert, was die Aufgabe nicht erlaubt. Bewertet wurde in der Welt der Aufgabe."

    override fun ownWorld() =
        "Die Welt wurde geändert, was die Aufgabe erlaubt. Bewertet wurde trotzdem in der Welt der Aufgabe."

    override fun unchanged() = "An den Programmen wurde nichts geändert."

    override fun sameName(count: Int, file: String) = "$count Abgaben haben diesen Namen. Diese ist aus $file."

    override fun languageNotAllowed(program: String) = "$program ist in einer Sprache, die die Aufgabe nicht erlaubt."

    override fun wordsNotAllowed(words: List<String>) =
        "Es benutzt Wörter, die die Aufgabe nicht erlaubt: ${listed(words, "und")}."

    override fun teachersFile() = "Das ist deine eigene Datei der Aufgabe."

    override fun isSolution() = "Das Programm ist dasselbe wie deine Lösung."

    override fun otherName(entered: String) = "In der Abgabe steht, dass sie von $entered ist."

    override fun bestCounts(chosen: String, all: List<String>) =
        "Gelaufen sind ${listed(all, "und")}: Es zählt $chosen, keines war besser."

    override fun chosenInApp(chosen: String, all: List<String>) =
        "Von ${listed(all, "und")} zählt $chosen: Das war in der App gewählt."

    override fun besideProject(programs: List<String>) =
        "Das Projekt zählt. Daneben ${if (programs.size == 1) "liegt" else "liegen"} ${listed(programs, "und")}."

    override fun fewerTries(origins: List<String>) =
        "Es zählt die Abgabe mit den meisten Versuchen, ohne ${listed(origins, "und")}."

    override fun notTried(origins: List<String>) =
        "Diese sind zu viele und liefen nicht mit: ${listed(origins, "und")}."

    override fun partUnusable(reason: String) = "Weggelassen: $reason"

    override fun compiledLeftOut(classes: List<String>) =
        "Der Quelltext zählt, ohne das Übersetzte in ${listed(classes, "und")}."
}
