package robotran.json.messages

internal object GermanJsonMessages :
    JsonMessages,
    JsonSyntaxMessages by GermanSyntax {
    override fun refused(line: Int, path: String, reason: String) =
        "Zeile $line: ${path.ifEmpty { "die Datei" }} $reason."

    override fun at(line: Int, path: String, sentence: String) =
        "Zeile $line: ${path.ifEmpty { "die Datei" }}: $sentence"

    override fun fileTooLong(limit: Int) = "Die Datei ist zu lang: Sie hat mehr als $limit Zeichen."

    override fun inLine(line: Int, sentence: String) = "Zeile $line: $sentence"

    override fun notText() = "Die Datei ist kein Text."

    override fun otherEncoding(encoding: String) = "Die Datei ist in $encoding, nicht in UTF-8."

    override fun misspelt(known: String) = "ist unbekannt und bewirkt nichts; vielleicht ist \"$known\" gemeint"

    override fun twice() = "ist zweimal da; nur das letzte zählt"

    override fun missingBut(written: String) = "fehlt; vielleicht ist \"$written\" dafür gemeint"

    override fun missing() = "fehlt"

    override fun mustBeObject() = "muss ein Objekt in geschweiften Klammern sein"

    override fun mustBeList() = "muss eine Liste in eckigen Klammern sein"

    override fun tooManyEntries(count: Int, limit: Int) = "hat $count Einträge, aber höchstens $limit sind erlaubt"

    override fun tooFewEntries(count: Int, min: Int) =
        "hat ${if (count == 1) "1 Eintrag" else "$count Einträge"}, aber mindestens $min müssen da sein"

    override fun mustBeText() = "muss ein Text in Anführungszeichen sein"

    override fun mustNotBeEmpty() = "darf nicht leer sein"

    override fun tooManyCharacters(limit: Int) = "darf nicht mehr als $limit Zeichen haben"

    override fun mustBeOneOrdinaryLine() = "muss eine Zeile mit gewöhnlichen Zeichen sein"

    override fun mustBeOrdinary() = "darf nur gewöhnliche Zeichen haben"

    override fun mustBeNumber() = "muss eine Zahl sein"

    override fun mustBeFrom(min: String, max: String) = "muss zwischen $min und $max liegen"

    override fun mustBeWholeFrom(min: Long, max: Long) = "muss eine ganze Zahl von $min bis $max sein"

    override fun mustBeTrueOrFalse() = "muss true oder false sein"

    override fun mustBeOneOf(words: Collection<String>) = "muss ${alternatives(words, "oder")} sein"
}
