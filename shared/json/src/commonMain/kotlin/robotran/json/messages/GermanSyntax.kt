package robotran.json.messages

internal object GermanSyntax : JsonSyntaxMessages {
    override fun emptyFile() = "Die Datei ist leer."

    override fun mustBeginWithBrace(line: Int) = "Zeile $line: Die Datei muss mit { beginnen."

    override fun textNotClosed(line: Int) = "In Zeile $line ist ein Text, der nicht mit einem Anführungszeichen endet."

    override fun bracketsTooDeep(line: Int) = "Zeile $line öffnet zu viele Klammern ineinander."

    override fun missingComma(line: Int, before: String) = "Zeile $line: Vor $before fehlt ein Komma."

    override fun missingCommaAtEnd(line: Int) = "Zeile $line: Am Ende fehlt ein Komma vor dem nächsten Eintrag."

    override fun lastComma(line: Int) = "In Zeile $line steht ein Komma nach dem letzten Eintrag. Nimm es weg."

    override fun extraComma(line: Int) = "In Zeile $line steht ein Komma, vor dem nichts ist. Nimm es weg."

    override fun comment(line: Int) = "In Zeile $line steht ein Kommentar, den JSON nicht kennt. Nimm ihn weg."

    override fun textNeedsQuotes(line: Int, text: String) =
        "Zeile $line: Ein Text steht in doppelten Anführungszeichen: \"$text\"."

    override fun nameNeedsQuotes(line: Int, name: String) =
        "Zeile $line: Der Name eines Feldes steht in doppelten Anführungszeichen: \"$name\"."

    override fun curlyQuotes(line: Int) =
        "In Zeile $line sind Anführungszeichen einer Textverarbeitung. Schreib gerade: \"."

    override fun quoteInText(line: Int) = "In Zeile $line ist ein Anführungszeichen in einem Text. Schreib es als \\\"."

    override fun writeInstead(line: Int, written: String, right: String) = "Zeile $line: Schreib $right statt $written."

    override fun decimalComma(line: Int, written: String, right: String) =
        "Zeile $line: Schreib $right mit Punkt statt $written."

    override fun noNumber(line: Int, written: String) = "Zeile $line: $written ist keine Zahl."

    override fun missingColon(line: Int, name: String) = "Zeile $line: Nach \"$name\" fehlt ein Doppelpunkt."

    override fun missingValue(line: Int, name: String) = "Zeile $line: Nach \"$name\" fehlt der Wert."

    override fun tabInText(line: Int) =
        "In Zeile $line ist ein Tabulator in einem Text. Schreib dafür \\t oder Leerzeichen."

    override fun invisibleInText(line: Int) = "In Zeile $line ist ein unsichtbares Zeichen in einem Text. Nimm es weg."

    override fun noEscape(line: Int, written: String) =
        "Zeile $line: $written bedeutet in einem Text nichts. Für den Backslash selbst schreib \\\\."

    override fun bracketNotClosed(line: Int, opening: String, closing: String) =
        "Zeile $line öffnet ein $opening, das kein $closing schließt."

    override fun wrongBracket(line: Int, found: String, opening: String, openLine: Int, closing: String) =
        "Zeile $line: Das $opening aus Zeile $openLine wird mit $closing geschlossen, nicht mit $found."

    override fun tooManyBrackets(line: Int, bracket: String) = "In Zeile $line ist ein $bracket zu viel."

    override fun goesOn(line: Int) = "Zeile $line: Nach der letzten Klammer der Datei darf nichts mehr stehen."

    override fun cannotStandThere(line: Int, sign: String) = "Zeile $line: $sign kann dort nicht stehen."
}
