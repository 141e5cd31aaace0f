package robotran.robolang.messages

import robotran.language.quoted

/** What is told in German about lines that cannot be read. */
internal object GermanSyntaxMessages : SyntaxMessages {
    override fun unknownCommand(word: String, suggestion: String?) =
        "Es gibt keinen Befehl ${quoted(word)}.${germanDidYouMean(suggestion)}"

    override fun missingCommand() = "Eine Zeile beginnt mit einem Befehl, zum Beispiel \"forward 20\"."

    override fun missingSpace(word: String, number: String) =
        "Zwischen ${quoted(word)} und ${quoted(number)} gehört ein Leerzeichen."

    override fun missingNumber(command: String, example: String) =
        "Nach ${quoted(command)} kommt eine Zahl, zum Beispiel ${quoted(example)}."

    override fun missingTurnDirection(suggestion: String?) =
        "Sag, in welche Richtung: \"turn left 90\" oder \"turn right 90\".${germanDidYouMean(suggestion)}"

    override fun missingPenPosition(suggestion: String?) =
        "Sag, wohin der Stift soll: \"pen down\" oder \"pen up\".${germanDidYouMean(suggestion)}"

    override fun missingTimes(count: String, suggestion: String?) =
        "Nach ${quoted("repeat $count")} kommt \"times\".${germanDidYouMean(suggestion)}"

    override fun missingTimeUnit(duration: String) =
        "Sag, wie lange: ${quoted("wait $duration seconds")} oder ${quoted("wait $duration milliseconds")}."

    override fun wrongUnit(command: String, unit: String, units: List<String>, suggestion: String?) =
        "${quoted(command)} misst in ${units.joinToString(" oder ")}, nicht in " +
            "${quoted(unit)}.${germanDidYouMean(suggestion)}"

    override fun severalCommands(second: String) = "Schreib ${quoted(second)} in eine eigene Zeile."

    override fun extraWords(extra: String, complete: String) =
        "Die Zeile ist nach ${quoted(complete)} fertig, also hat ${quoted(extra)} hier keinen Platz."

    override fun missingEnd(block: String) =
        "Zu diesem ${quoted(block)} fehlt das \"end\". Schreib \"end\" in eine eigene Zeile, dort wo der Block aufhört."

    override fun extraEnd() = "Dieses \"end\" schließt keinen Block."

    override fun unknownCharacter(character: String) = "Das Zeichen ${quoted(character)} bedeutet hier nichts."

    override fun invisibleCharacter(code: String) = "Hier ist ein Zeichen, das man nicht sieht ($code). Lösch es."

    override fun characterInsteadOf(written: String, right: String) = germanWriteInstead(written, right)

    override fun commentBegins() = "Ein Kommentar beginnt mit \"//\"."

    override fun semicolon() = "Eine Zeile braucht keinen Strichpunkt."

    override fun numberTooLarge(smallest: Int, largest: Int) =
        "Diese Zahl ist zu groß. Zahlen gehen von $smallest bis $largest."

    override fun malformedNumber(number: String, right: String?) =
        if (right == null) "${quoted(number)} ist keine Zahl." else germanWriteInstead(number, right)

    override fun decimalComma(right: String?) = if (right ==
        null
    ) {
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
        "Nach ${quoted(before)} kommt ${quoted(word)}.${germanDidYouMean(suggestion)}"

    override fun missingButton(suggestion: String?) =
        "Sag, welche Taste: \"button run\", \"button view\" oder \"button prgm\".${germanDidYouMean(suggestion)}"

    override fun missingMove(suggestion: String?) =
        "Sag, was beginnen soll: \"start forward\", \"start backward\" oder \"start turning " +
            "left\".${germanDidYouMean(suggestion)}"

    override fun missingMotor() = "Sag, welcher Motor: A, B oder C."

    override fun missingMotorCommand(motor: String, suggestion: String?) =
        "Sag, was Motor $motor tun soll: forward, backward, stop, float oder power.${germanDidYouMean(suggestion)}"

    override fun missingFacing(suggestion: String?) =
        "Sag, wohin der Lichtsensor schaut: \"facing down\" oder \"facing forward\".${germanDidYouMean(suggestion)}"

    override fun portOutOfRange() = "Die Sensoren heißen 1, 2 und 3, zum Beispiel \"sensor 2\"."

    override fun lengthAndTime() = "Sag, wie weit oder wie lange, nicht beides."

    override fun extraElse() = "Zu diesem \"else\" gibt es kein \"if\"."

    override fun notOutermost(word: String) =
        "Ein ${quoted(word)} kann nicht in einem anderen Block stehen. Hol es heraus."

    override fun secondRobot() = "Es gibt schon ein \"robot\". Ein Programm hat nur eins."

    override fun unknownSetting() =
        "Zwischen \"robot\" und \"end\" steht nur der Lichtsensor, zum Beispiel \"light sensor on 2 facing down\"."

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

    override fun missingComma(second: String) = "Vor ${quoted(second)} gehört ein Komma."

    override fun textAsValue(text: String) = "Einen Text wie $text kann man nur zeigen, mit \"show\"."
}
