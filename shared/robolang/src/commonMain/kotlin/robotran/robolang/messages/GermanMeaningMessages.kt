package robotran.robolang.messages

import robotran.language.quoted

/** What is told in German about lines that make no sense. */
internal object GermanMeaningMessages : MeaningMessages {
    override fun countNotWhole(count: String) =
        "Ein Block kann nicht $count-mal wiederholt werden. Nimm eine ganze Zahl."

    override fun countNegative(count: String) = "Ein Block kann nicht $count-mal wiederholt werden. Nimm 0 oder mehr."

    override fun waitNegative() = "Der Roboter kann nicht kürzer als gar nicht warten. Nimm 0 oder mehr."

    override fun durationTooLong() = "Das würde länger als einen Tag dauern. Nimm eine kleinere Zahl."

    override fun unknownVariable(name: String, suggestion: String?) =
        "Es gibt keine Variable ${quoted(name)}.${germanDidYouMean(suggestion)}"

    override fun unknownRoutine(name: String, suggestion: String?) =
        "Es gibt keine Prozedur oder Funktion ${quoted(name)}.${germanDidYouMean(suggestion)}"

    override fun usedBeforeDeclaration(name: String, line: Int) =
        "${quoted(name)} wird erst in Zeile $line angelegt. Schieb die Zeile nach oben."

    override fun declaredTwice(name: String, line: Int) =
        "${quoted(name)} ist schon angelegt, in Zeile $line. Nimm einen anderen Namen."

    override fun declaredBuiltIn(name: String) =
        "Robolang hat schon eine Funktion ${quoted(name)}. Nimm einen anderen Namen."

    override fun assignedConstant(name: String) =
        "${quoted(name)} ist eine Konstante und ändert sich nie. Wenn es sich ändern soll, leg es mit \"var\" an."

    override fun assignedLoopVariable(name: String) =
        "${quoted(name)} wird von seinem \"for\" gezählt und kann hier nicht geändert werden."

    override fun numberNeeded(text: String) = "Hier muss eine Zahl stehen, und ${quoted(text)} ist keine."

    override fun wholeNumberNeeded(text: String) =
        "Hier muss eine ganze Zahl stehen, und ${quoted(text)} ist eine Kommazahl. Nimm \"round\"."

    override fun conditionNeeded(text: String) = "Hier muss eine Bedingung stehen, und ${quoted(text)} ist keine."

    override fun listNeeded(text: String) = "Hier muss eine Liste stehen, und ${quoted(text)} ist keine."

    override fun valueNeeded(name: String) =
        "${quoted(name)} ist eine Prozedur und gibt keinen Wert. Das tut nur eine Funktion."

    override fun decimalForWhole(name: String) =
        "${quoted(name)} ist mit einer ganzen Zahl angelegt, also passt keine Kommazahl hinein. Leg es mit einer " +
            "Kommazahl an, zum Beispiel 0.0."

    override fun typeChanged(name: String) = "${quoted(name)} ist mit einem Wert anderer Art angelegt."

    override fun notComparable() = "Vergleichen kann man nur zwei Zahlen oder zwei Bedingungen."

    override fun mixedList(text: String) = "In einer Liste stehen nur Zahlen, und ${quoted(text)} ist keine."

    override fun emptyList() = "Eine Liste braucht mindestens eine Zahl."

    override fun listTooLong(limit: Int) = "Eine Liste kann höchstens $limit Elemente haben."

    override fun indexOutOfRange(last: Int) = "Diese Liste hat die Elemente 0 bis $last."

    override fun indexNegative() = "Die Elemente einer Liste werden ab 0 gezählt."

    override fun wrongArgumentCount(name: String, needed: Int, given: Int) =
        "${quoted(name)} nimmt ${values(needed)}, nicht $given."

    override fun functionAsCommand(name: String) =
        "${quoted(name)} gibt einen Wert. Benutz ihn, zum Beispiel mit \"show $name(...)\"."

    override fun outsideLoop(word: String) = "${quoted(word)} gehört in eine Schleife."

    override fun outsideRoutine() =
        "\"return\" gehört in eine Prozedur oder Funktion. Um das Programm zu beenden, schreib \"halt\"."

    override fun returnWithValue(name: String) =
        "${quoted(name)} ist eine Prozedur und gibt keinen Wert. Wenn sie das soll, schreib \"function\" statt " +
            "\"procedure\"."

    override fun returnWithoutValue(name: String) =
        "${quoted(name)} ist eine Funktion. Sag, welchen Wert sie gibt, zum Beispiel \"return 5\"."

    override fun missingReturn(name: String) =
        "${quoted(name)} ist eine Funktion, kann aber ohne \"return\" mit einem Wert an ihr Ende kommen."

    override fun durationNegative() = "Nichts kann kürzer als gar nicht dauern. Nimm 0 oder mehr."

    override fun powerOutOfRange() = "Die Leistung eines Motors geht von 0 bis 7."

    override fun textTooLong(limit: Int) = "In die Anzeige passen $limit Zeichen."

    override fun textNotShown(character: String) =
        "Die Anzeige kann ${quoted(character)} nicht zeigen. Sie hat Buchstaben, Ziffern, Leerzeichen, \"-\" und \"_\"."

    override fun divisionByZero() = "Durch 0 kann man nicht teilen."

    override fun stepZero() = "Mit einer Schrittweite von 0 würde das nie aufhören."

    override fun tooManyVariables(limit: Int) = "Der Stein hat hier Platz für $limit Variablen. Das ist eine mehr."

    override fun tooManyParameters(limit: Int) = "Der Stein hat Platz für $limit Werte in Klammern. Das ist einer mehr."

    override fun tooManyConstants(limit: Int) =
        "Der Stein hat Platz für $limit verschiedene große Zahlen, Kommazahlen und Texte. Das ist eins mehr."

    override fun tooManyRoutines(limit: Int) =
        "Der Stein hat Platz für $limit Prozeduren und Funktionen. Das ist eine mehr."

    override fun undeclaredVariable(name: String) =
        "Es gibt noch keine Variable ${quoted(name)}. Schreib \"var\" davor, um sie anzulegen."

    override fun calledBeforeDeclaration(routine: String, variable: String, line: Int) =
        "${quoted(routine)} benutzt ${quoted(variable)}, und das wird erst in Zeile $line angelegt. Schieb die Zeile " +
            "nach oben."

    override fun calledInDeclaration(routine: String, variable: String) =
        "${quoted(routine)} benutzt ${quoted(variable)}, und das bekommt seinen ersten Wert erst hier."

    override fun neededBeforeDeclaration(variable: String, line: Int) =
        "Ein \"whenever\" kann ${quoted(variable)} sofort brauchen, aber es wird erst in Zeile $line angelegt. " +
            "Schieb die Zeile ganz nach oben."

    override fun redeclared(name: String, line: Int) =
        "${quoted(name)} ist schon angelegt, in Zeile $line. Um es zu ändern, lass \"var\" weg."

    override fun chainedComparison(right: String) = "Vergleich zweimal: ${quoted(right)}."

    private fun values(count: Int) = if (count == 1) "1 Wert" else "$count Werte"
}
