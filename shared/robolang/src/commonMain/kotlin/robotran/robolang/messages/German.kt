package robotran.robolang.messages

import robotran.language.Language
import robotran.language.pasted.PastedCharacter
import robotran.language.quoted

/**
 * The messages in German. They address the pupil as "du". Each term has one translation: brick - Stein, bracket -
 * Klammer, command - Befehl, condition - Bedingung, declare - anlegen, display - Anzeige, digit - Ziffer, line - Zeile,
 * loop - Schleife, power - Leistung, text - Text, value - Wert, whole number - ganze Zahl, decimal number - Kommazahl.
 * Words of Robolang are quoted and not translated.
 */
object GermanRobolangMessages :
    RobolangMessages,
    SyntaxMessages by GermanSyntaxMessages,
    MeaningMessages by GermanMeaningMessages,
    WarningMessages by GermanWarningMessages,
    BrickKindMessages by GermanBrickKindMessages,
    RunMessages by GermanRunMessages

/** The messages about syntax errors in German. */
private object GermanSyntaxMessages : SyntaxMessages {
    override fun unknownCommand(word: String, suggestion: String?) =
        "Es gibt keinen Befehl ${quoted(word)}.${didYouMean(suggestion)}"

    override fun missingCommand() = "Eine Zeile beginnt mit einem Befehl, zum Beispiel \"forward 20\"."

    override fun missingSpace(word: String, number: String) =
        "Zwischen ${quoted(word)} und ${quoted(number)} gehört ein Leerzeichen."

    override fun missingNumber(command: String, example: String) =
        "Nach ${quoted(command)} kommt eine Zahl, zum Beispiel ${quoted(example)}."

    override fun startInstead(start: String) =
        "Soll der Roboter fahren, bis etwas geschieht, dann schreib ${quoted(start)}."

    override fun missingTurnDirection(suggestion: String?) =
        "Sag, in welche Richtung: \"turn left 90\" oder \"turn right 90\".${didYouMean(suggestion)}"

    override fun missingPenPosition(suggestion: String?) =
        "Sag, wohin der Stift soll: \"pen down\" oder \"pen up\".${didYouMean(suggestion)}"

    override fun missingTimes(count: String, suggestion: String?) =
        "Nach ${quoted("repeat $count")} kommt \"times\".${didYouMean(suggestion)}"

    override fun missingTimeUnit(duration: String) =
        "Sag, wie lange: ${quoted("wait $duration seconds")} oder ${quoted("wait $duration milliseconds")}."

    override fun wrongUnit(command: String, unit: String, units: List<String>, suggestion: String?) =
        "${quoted(command)} misst in ${units.joinToString(" oder ")}, nicht in " +
            "${quoted(unit)}.${didYouMean(suggestion)}"

    override fun severalCommands(second: String) = "Schreib ${quoted(second)} in eine eigene Zeile."

    override fun extraWords(extra: String, complete: String) =
        "Die Zeile ist nach ${quoted(complete)} fertig, also hat ${quoted(extra)} hier keinen Platz."

    override fun missingEnd(block: String) =
        "Zu diesem ${quoted(block)} fehlt das \"end\". Schreib \"end\" in eine eigene Zeile, dort wo der Block aufhört."

    override fun extraEnd() = "Dieses \"end\" schließt keinen Block."

    override fun unknownCharacter(character: String) = "Das Zeichen ${quoted(character)} bedeutet hier nichts."

    override fun invisibleCharacter(code: String) = "Hier ist ein Zeichen, das man nicht sieht ($code). Lösch es."

    override fun pastedCharacter(pasted: PastedCharacter, written: String) = pasted.adviceIn(Language.GERMAN, written)

    override fun characterInsteadOf(written: String, right: String) = writeInstead(written, right)

    override fun commentBegins() = "Ein Kommentar beginnt mit \"//\"."

    override fun semicolon() = "Eine Zeile braucht keinen Strichpunkt."

    override fun numberTooLarge(smallest: Int, largest: Int) =
        "Diese Zahl ist zu groß. Zahlen gehen von $smallest bis $largest."

    override fun malformedNumber(number: String, right: String?) =
        if (right == null) "${quoted(number)} ist keine Zahl." else writeInstead(number, right)

    override fun decimalComma(right: String?) = if (right == null) {
        "Eine Zahl hat hier einen Punkt, kein Komma."
    } else {
        "Eine Zahl hat hier einen Punkt, kein Komma. Schreib $right."
    }

    override fun nestedTooDeeply(limit: Int) = "Höchstens $limit Blöcke können ineinander stehen."

    override fun sourceTooLong(limit: Int) = "Ein Programm kann höchstens $limit Zeichen haben. Dieses hat mehr."

    override fun unclosedText() = "Ein Text endet mit einem Anführungszeichen."

    override fun useTwoEqualsSigns() = "Zum Vergleichen nimmst du \"==\"."

    override fun useOneEqualsSign() = "Mit \"=\" gibst du einer Variable ihren Wert."

    override fun combinedAssignment(name: String, operator: String) =
        "Schreib stattdessen ${quoted("$name = $name $operator ...")}."

    override fun missingCondition(command: String, example: String) =
        "Nach ${quoted(command)} kommt eine Bedingung, zum Beispiel ${quoted(example)}."

    override fun missingValue(command: String, example: String) =
        "Nach ${quoted(command)} kommt ein Wert, zum Beispiel ${quoted(example)}."

    override fun missingOperand(before: String) = "Nach ${quoted(before)} fehlt ein Wert."

    override fun missingAssignment(before: String, example: String) =
        "Nach ${quoted(before)} kommen \"=\" und ein Wert, zum Beispiel ${quoted(example)}."

    override fun missingName(before: String, example: String) =
        "Nach ${quoted(before)} kommt ein Name, zum Beispiel ${quoted(example)}."

    override fun reservedWord(word: String) = "${quoted(word)} ist ein Wort von Robolang. Nimm einen anderen Namen."

    override fun missingBracket(opening: String, closing: String) =
        "Zu diesem ${quoted(opening)} fehlt das ${quoted(closing)}."

    override fun missingBracketsOfCall(name: String) =
        "Um ${quoted(name)} aufzurufen, schreib seine Werte in Klammern dahinter, oder leere Klammern, wenn es keine " +
            "hat."

    override fun missingBracketsOfRoutine(name: String) =
        "Nach ${quoted(name)} kommen Klammern, mit den Namen seiner Werte darin oder leer."

    override fun missingWord(before: String, word: String, suggestion: String?) =
        "Nach ${quoted(before)} kommt ${quoted(word)}.${didYouMean(suggestion)}"

    override fun missingButton(suggestion: String?) =
        "Sag, welche Taste: \"button run\", \"button view\" oder \"button prgm\".${didYouMean(suggestion)}"

    override fun missingMove(suggestion: String?) =
        "Sag, was beginnen soll: \"start forward\", \"start backward\" oder \"start turning " +
            "left\".${didYouMean(suggestion)}"

    override fun missingMotor() = "Sag, welcher Motor: A, B oder C."

    override fun missingMotorCommand(motor: String, suggestion: String?) =
        "Sag, was Motor $motor tun soll: forward, backward, stop, float oder power.${didYouMean(suggestion)}"

    override fun missingFacing(suggestion: String?) =
        "Sag, wohin der Lichtsensor schaut: \"facing down\" oder \"facing forward\".${didYouMean(suggestion)}"

    override fun lengthAndTime() = "Sag, wie weit oder wie lange, nicht beides."

    override fun extraElse() = "Zu diesem \"else\" gibt es kein \"if\"."

    override fun notOutermost(word: String) =
        "Ein ${quoted(word)} kann nicht in einem anderen Block stehen. Hol es heraus."

    override fun secondRobot() = "Es gibt schon ein \"robot\". Ein Programm hat nur eins."

    override fun unknownSetting() =
        "Zwischen \"robot\" und \"end\" stehen nur der Stein und seine Sensoren, zum Beispiel \"light sensor on 2 " +
            "facing down\"."

    override fun secondSetting() = "Der Lichtsensor ist schon eingestellt."

    override fun expressionTooDeep(limit: Int) =
        "Höchstens $limit Klammern und Rechenzeichen können ineinander stehen. Nimm für einen Teil eine Variable."

    override fun valueAsCommand(word: String) =
        "${quoted(word)} hat einen Wert, tut aber nichts. Nimm es in einem Befehl, zum Beispiel \"show light\"."

    override fun settingOutsideRobot() = "Das gehört zwischen eine Zeile \"robot\" und ihr \"end\"."

    override fun colon() = "Eine Zeile braucht keinen Doppelpunkt."

    override fun brace(brace: String) = "Ein Block braucht kein ${quoted(brace)}. Er hört mit einer Zeile \"end\" auf."

    override fun malformedName(name: String) =
        "${quoted(name)} ist kein Name. Ein Name beginnt mit einem Buchstaben und hat Buchstaben, Ziffern und \"_\"."

    override fun nameOfSeveralWords(right: String) = "Ein Name ist ein einziges Wort. Schreib ${quoted(right)}."

    override fun missingComma(second: String) = "Vor ${quoted(second)} gehört ein Komma."

    override fun textAsValue(text: String) = "Einen Text wie $text kann man nur zeigen, mit \"show\"."
}

/** The messages about semantic errors in German. */
private object GermanMeaningMessages : MeaningMessages {
    override fun countNotWhole(count: String) =
        "Ein Block kann nicht $count-mal wiederholt werden. Nimm eine ganze Zahl."

    override fun countNegative(count: String) = "Ein Block kann nicht $count-mal wiederholt werden. Nimm 0 oder mehr."

    override fun waitNegative() = "Der Roboter kann nicht kürzer als gar nicht warten. Nimm 0 oder mehr."

    override fun durationTooLong() = "Das würde länger als einen Tag dauern. Nimm eine kleinere Zahl."

    override fun unknownVariable(name: String, suggestion: String?) =
        "Es gibt keine Variable ${quoted(name)}.${didYouMean(suggestion)}"

    override fun unknownRoutine(name: String, suggestion: String?) =
        "Es gibt keine Prozedur oder Funktion ${quoted(name)}.${didYouMean(suggestion)}"

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

/** The warnings in German. */
private object GermanWarningMessages : WarningMessages {
    override fun unusedVariable(name: String) = "${quoted(name)} wird nie benutzt."

    override fun neverReached(word: String) = "Das kommt nie dran, weil davor ${quoted(word)} steht."

    override fun busyLoop() =
        "Das geht ewig weiter, ohne zu fahren, zu warten oder zu messen, und beschäftigt nur den Stein."

    override fun fractionLost(division: String, result: Int) =
        "Ganze Zahlen geteilt ergeben eine ganze Zahl: ${quoted(division)} ist $result. Schreib eine davon mit " +
            "Punkt, wenn du es genauer willst."

    override fun divisorTooLarge(divisor: Int, kept: Int) =
        "Der Stein teilt nur durch Zahlen von -32768 bis 32767. Er nimmt $kept statt $divisor."

    override fun listInLoop() =
        "Das macht immer wieder eine neue Liste, und der Stein bekommt den Speicher nie zurück. Mach die Liste " +
            "einmal, ganz oben."

    override fun divisorTakenForZero(divisor: Int) =
        "Der Stein teilt nur durch Zahlen von -32768 bis 32767. Er nimmt 0 statt $divisor und hält an."

    override fun endlessRecursion(name: String) =
        "${quoted(name)} ruft immer sich selbst auf und kommt so nie an sein Ende."
}

/** The messages about runtime errors in German. */
private object GermanRunMessages : RunMessages {
    override fun divisionByZero(dividend: String) = "$dividend kann man nicht durch 0 teilen."

    override fun indexOutside(index: Int, size: Int) = when (size) {
        0 -> "Es gibt kein Element $index, die Liste ist leer."
        1 -> "Es gibt kein Element $index in einer Liste von 1, nur das Element 0."
        else -> "Es gibt kein Element $index in einer Liste von $size. Gezählt wird von 0 bis ${size - 1}."
    }

    override fun tooManyCalls(name: String, limit: Int) =
        "${quoted(name)} ruft sich zu oft selbst auf: Im Speicher des Steins ist nur Platz für $limit Aufrufe " +
            "ineinander."

    override fun listsInUseTooLarge(limit: Int) =
        "Der Speicher des Steins ist voll: Die Listen, die noch gebraucht werden, haben mehr als $limit Elemente."

    override fun listsTooLarge(limit: Int) =
        "Der Speicher des Steins ist voll: Alle Listen bis jetzt haben zusammen mehr als $limit Elemente, und er " +
            "behält jedes."

    override fun negativeTime(value: String) = "Eine Zeit von $value gibt es für den Roboter nicht. Nimm 0 oder mehr."

    override fun negativeCount(value: Int) = "Nichts kann $value-mal wiederholt werden. Nimm 0 oder mehr."

    override fun powerOutside(value: Int) = "Ein Motor hat keine Leistung $value, nur 0 bis 7."

    override fun stepOfNothing() = "Mit Schritten von 0 käme die Schleife nie weiter."

    override fun rootOfNegative(value: String) = "$value hat keine Quadratwurzel, denn es ist kleiner als 0."

    override fun powerOfNegative(base: String, exponent: String) = "Es gibt keine Zahl, die $base hoch $exponent ist."

    override fun nothingReturned(name: String) = "Die Funktion ${quoted(name)} kam ohne ein \"return\" an ihr Ende."
}

private fun didYouMean(suggestion: String?) = if (suggestion == null) "" else " Meinst du ${quoted(suggestion)}?"

private fun writeInstead(written: String, right: String) = "Schreib ${quoted(right)} statt ${quoted(written)}."
