package robotran.nqc.messages

import robotran.language.Language
import robotran.language.pasted.PastedCharacter
import robotran.language.quoted
import robotran.nqc.config.ParameterLimit

/**
 * The messages in German. They address the pupil as "du". Each term has one translation: array - Array, block - Block,
 * brace - geschweifte Klammer, brick - Stein, bracket - Klammer, condition - Bedingung, declare - anlegen,
 * function - Funktion, label - Marke, loop - Schleife, pointer - Zeiger, semicolon - Strichpunkt, sub - Unterprogramm,
 * task - Task, variable - Variable. Words of NQC are not translated.
 */
object GermanNqcMessages :
    NqcMessages,
    DirectiveMessages by GermanDirectiveMessages,
    NqcSyntaxMessages by GermanSyntaxMessages,
    NqcNameMessages by GermanNameMessages,
    NqcCodeMessages by GermanCodeMessages

private object GermanDirectiveMessages : DirectiveMessages {
    override fun fileNotFound(name: String) = "In diesem Programm gibt es keine Datei ${quoted(name)}."

    override fun includeNeedsName() =
        "Nach #include kommt der Name einer Datei in Anführungszeichen: #include \"meine.nqh\"."

    override fun tooManyIncludes() = "Zu viele Dateien binden einander ein. Bindet eine Datei sich selbst ein?"

    override fun directiveNeedsName(directive: String) = "Nach #$directive kommt ein Name, zum Beispiel \"TEMPO\"."

    override fun macroRedefined(name: String) =
        "${quoted(name)} ist schon festgelegt. Nimm einen anderen Namen oder schreib vorher #undef $name."

    override fun macroParameters(name: String) =
        "Nach ${quoted(name)} kommt ein Leerzeichen oder die Parameter in Klammern: #define $name(a, b)."

    override fun signInDefinition(sign: String, name: String) = if (sign == ";") {
        "Die Zeile eines #define endet ohne Strichpunkt. Dieser gerät in jede Zeile mit $name."
    } else {
        "Zwischen $name und seinem Wert steht in einem #define kein $sign."
    }

    override fun macroCircular(name: String) =
        "${quoted(name)} ist durch sich selbst festgelegt und wird nie ein Wert. Prüf das #define."

    override fun macroArguments(name: String, count: Int) = when (count) {
        0 -> "${quoted(name)} braucht leere Klammern: $name()."
        1 -> "${quoted(name)} braucht ein Argument in Klammern: $name(1)."
        else -> "${quoted(name)} braucht $count Argumente in Klammern, mit Kommas dazwischen."
    }

    override fun macrosTooLong(name: String) =
        "Die Festlegungen um ${quoted(name)} machen das Programm viel zu lang. Setz weniger davon ineinander."

    override fun unterminatedIf() = "Dieses #if hört nicht auf. Schreib #endif, wo es endet."

    override fun elseWithoutIf(directive: String) = "Vor diesem #$directive steht kein #if."

    override fun unknownDirective(directive: String) = if (directive.isEmpty()) {
        "Nach # kommt ein Wort wie \"define\"."
    } else {
        "#$directive gibt es nicht. NQC kennt #define, #undef, #include, #if, #ifdef, #else, #endif und #pragma."
    }

    override fun conditionSyntax() =
        "Diese Bedingung lässt sich nicht berechnen. Sie darf Zahlen, Namen, defined(NAME) und Rechenzeichen haben."

    override fun conditionIncomplete() = "Die Bedingung hört zu früh auf: Eine Zahl oder ein Name fehlt."

    override fun conditionBrackets() = "Die Klammern dieser Bedingung passen nicht zusammen."

    override fun unterminatedComment() = "Dieser Kommentar hört nicht auf. Schreib */, wo er endet."

    override fun errorDirective(text: String) =
        "Das Programm sagt selbst, dass hier etwas nicht stimmt: ${text.ifEmpty { "#error" }}"

    override fun warningDirective(text: String) = "Das Programm warnt selbst: ${text.ifEmpty { "#warning" }}"

    override fun unknownPragma(word: String) = if (word.isEmpty()) {
        "Nach #pragma kommt \"noinit\", \"init\" mit einer Funktion oder \"reserve\" mit Zahlen."
    } else {
        "NQC beachtet das #pragma ${quoted(
            word,
        )} nicht. Es kennt noinit, init mit einer Funktion und reserve mit Zahlen."
    }

    override fun notReserved(last: Int) =
        "Diese Variablen lassen sich nicht reservieren. Die Nummern gehen von 0 bis $last, und jede nur einmal."
}

private object GermanSyntaxMessages : NqcSyntaxMessages {
    override fun unexpected(text: String) = "${quoted(text)} passt hier nicht. Fehlt davor etwas?"

    override fun unexpectedEnd() = "Das Programm hört zu früh auf."

    override fun unknownCharacter(character: String) = "Das Zeichen ${quoted(character)} bedeutet hier nichts."

    override fun pastedCharacter(pasted: PastedCharacter, written: String) = pasted.adviceIn(Language.GERMAN, written)

    override fun decimalNumber() =
        "Der Stein rechnet nur mit ganzen Zahlen. Zähl in kleineren Schritten, etwa in Zehnteln oder Hundertsteln."

    override fun decimalTime(seconds: String, hundredths: Int) =
        "NQC hat keine Kommazahlen und zählt Zeit in Hundertstelsekunden: Schreib $hundredths für $seconds Sekunden."

    override fun misspelledWord(typed: String, meant: String, isCase: Boolean) =
        "${quoted(typed)} ist kein Wort von NQC. Meinst du ${quoted(meant)}?" +
            if (isCase) " Groß- und Kleinbuchstaben sind nicht dasselbe." else ""

    override fun otherType(type: String) = "$type gibt es in NQC nicht, nur ganze Zahlen: int."

    override fun textAsValue() = "Der Stein kann keine Texte zeigen, darum hat NQC keine. Nimm eine Zahl."

    override fun quotedName(name: String) = "Schreib $name ohne Anführungszeichen."

    override fun nestedUnit(name: String) =
        "${quoted(name)} kann nicht in einem Task, einem Unterprogramm oder einer Funktion stehen. Setz es davor " +
            "oder dahinter."

    override fun mainFunction(right: String) = "Der Haupttask beginnt so: $right"

    override fun taskWithBrackets(command: String, task: String) =
        "Nach $command kommt der Name des Tasks ohne Klammern: $command $task;"

    override fun taskCommand(written: String, right: String) =
        "${quoted(written)} ist kein Befehl von NQC. Schreib: $right;"

    override fun taskParameters(name: String) =
        "Ein Task hat nichts in den Klammern: task $name(). Nimm stattdessen eine globale Variable."

    override fun constantVariable(right: String) = "Nur Parameter sind in NQC const. Schreib: $right"

    override fun extraWord(word: String) = "${quoted(word)} gibt es in NQC nicht. Lass dieses Wort weg."

    override fun missingSemicolon() = "Hier fehlt ein Strichpunkt."

    override fun missing(sign: String) = "Hier fehlt ${quoted(sign)}."

    override fun missingBrace(line: Int) =
        "Der Block, der in Zeile $line beginnt, hört nicht auf. Schreib }, wo er endet."

    override fun extraBrace() = "Diese } schließt nichts."

    override fun missingValue(before: String) = "Nach ${quoted(before)} fehlt ein Wert."

    override fun missingName(before: String, word: String?) = if (word == null) {
        "Nach ${quoted(before)} fehlt ein Name."
    } else {
        "${quoted(word)} ist ein Wort von NQC und kann kein Name sein. Nimm einen anderen."
    }

    override fun missingBlock(before: String) = "Nach ${quoted(before)} kommt ein Block in geschweiften Klammern: { }."

    override fun missingColon(word: String) = "Der Doppelpunkt zu ${quoted(word)} fehlt."

    override fun callAsValue(name: String) =
        "${quoted(name)} tut etwas, gibt aber keinen Wert. Schreib es in eine eigene Zeile."

    override fun assignmentAsValue() = "Ein = weist zu. Zum Vergleichen schreib zwei: ==."

    override fun secondChoice() = "Setz die zweite Auswahl mit ? in Klammern."

    override fun returnWithValue() = "Eine Funktion in NQC gibt keinen Wert zurück. Schreib nur: return;"

    override fun functionWithType(name: String) =
        "Eine Funktion in NQC gibt keinen Wert, darum beginnt sie mit void: void $name(). Sie kann globale Variablen ändern."

    override fun inlineWritten() = "In NQC sind alle Funktionen schon inline. Lass dieses Wort weg."

    override fun catchAlone() = "Direkt vor diesem catch steht kein monitor oder acquire mit einem Block."

    override fun elseAlone() =
        "Direkt vor diesem else steht kein if. Zwei Zeilen nach einem if brauchen geschweifte Klammern."

    override fun doWithoutWhile() = "Nach dem Block von do kommt: while (Bedingung);"

    override fun declarationInFor() = "Leg die Variable vor der Schleife an: int i; for (i = 0; i < 3; i++)."

    override fun statementAfterLabel() = "Vor } fehlt ein Befehl; ein einzelner Strichpunkt genügt."

    override fun outsideTask(text: String) = "${quoted(
        text,
    )} muss in einem Task, Unterprogramm oder einer Funktion stehen. Ein Programm beginnt mit task main()."

    override fun parameterNeedsType(text: String) =
        "Ein Parameter beginnt mit int, const int oder __sensor, nicht mit ${quoted(text)}."

    override fun resourceWritten() = "__res ist für Spybots; ein RCX hat so etwas nicht."

    override fun sourceTooLong(limit: Int) = "Die Datei ist zu lang. Höchstens $limit Zeichen sind möglich."

    override fun programTooLong() = "Das Programm ist viel zu lang für einen Stein."

    override fun nestedTooDeeply(limit: Int) = "Hier steht zu viel ineinander. Höchstens $limit Ebenen sind möglich."

    override fun numberTooLarge() = "Diese Zahl ist viel zu groß. Der Stein rechnet mit -32768 bis 32767."

    override fun noEffect() = "Diese Zeile tut nichts. Wolltest du mit = etwas zuweisen oder eine Funktion aufrufen?"

    override fun emptyBody(word: String) =
        "Dieser Strichpunkt beendet das $word, also gehört das Folgende nicht mehr dazu. Lösch ihn."

    override fun misleadingIndent(word: String) =
        "Diese Zeile gehört nicht zum $word: Ohne geschweifte Klammern gehört nur eine dazu. Setz { } um beide."
}

private object GermanNameMessages : NqcNameMessages {
    override fun mainMissing(suggestion: String?) = if (suggestion == null) {
        "Das Programm hat keinen Haupttask. Es beginnt mit: task main() { }"
    } else {
        "Der Task, mit dem das Programm beginnt, muss main heißen, nicht $suggestion."
    }

    override fun redeclared(name: String, line: Int?) = if (line == null) {
        "${quoted(name)} ist ein Name von NQC selbst. Nimm einen anderen."
    } else {
        "${quoted(name)} ist schon angelegt, in Zeile $line. Nimm einen anderen Namen."
    }

    override fun undefinedVariable(name: String, suggestion: String?) =
        "Es gibt keine Variable ${quoted(name)}. ${didYouMean(suggestion) ?: "Leg sie zuerst an: int $name;"}"

    override fun notOfSeries(name: String, others: List<String>) =
        "Es gibt kein ${quoted(name)}. Es gibt: ${others.joinToString()}"

    override fun sensorByName(right: String) = "Ein Sensor wird allein mit seinem Namen gelesen: $right"

    override fun undefinedCommand(name: String, suggestion: String?) =
        "Es gibt nichts mit dem Namen ${quoted(name)}. " +
            (didYouMean(suggestion) ?: "Ein Befehl sieht so aus: OnFwd(OUT_A);")

    override fun bracketsMissing(name: String, call: String) = "Nach ${quoted(name)} kommen Klammern: $call;"

    override fun undefinedFunction(name: String, suggestion: String?) =
        "Es gibt keine Funktion ${quoted(name)}. ${didYouMean(suggestion) ?: "Prüf, wie sie geschrieben wird."}"

    override fun undefinedTask(name: String, suggestion: String?) =
        "Es gibt keinen Task ${quoted(name)}. ${didYouMean(suggestion) ?: "Schreib ihn: task $name() { }"}"

    override fun taskCalled(name: String) = "${quoted(name)} ist ein Task. Schreib: start $name;"

    override fun needsSecondFirmware(name: String) =
        "${quoted(name)} braucht Firmware 2.0. Dieses Programm ist für Firmware 1.0 (Ziel RCX)."

    override fun taskNeverStarted(name: String) = "Nichts startet den Task ${quoted(name)}. Schreib: start $name;"

    override fun undefinedLabel(name: String) =
        "Hier gibt es keine Marke ${quoted(name)}. Sie muss im selben Task, Unterprogramm oder in derselben Funktion " +
            "stehen: $name:"

    override fun labelRedefined(name: String) = "Die Marke ${quoted(name)} gibt es zweimal. Nimm einen anderen Namen."

    override fun initUndefined(name: String) = "#pragma init nennt ${quoted(name)}, aber so heißt keine Funktion."

    override fun isArray(name: String) = "${quoted(name)} ist ein Array. Sag, welches Element: $name[0]."

    override fun isNotArray(name: String) = "${quoted(name)} ist kein Array und hat keine Elemente. Lass [ ] weg."

    override fun isNotPointer(name: String) = "${quoted(name)} ist kein Zeiger. Leg ihn mit einem Stern an: int *$name;"

    override fun arrayInitialized(name: String) =
        "Ein Array bekommt beim Anlegen keinen Wert. Weise seinen Elementen etwas zu: $name[0] = 1;"

    override fun argumentCount(name: String, needed: Int, given: Int, call: String) = when (needed) {
        0 -> "${quoted(name)} hat nichts in den Klammern: $name()."
        1 -> "${quoted(name)} braucht ein Argument, hier sind es $given. Schreib es so: $call;"

        else -> "${quoted(
            name,
        )} braucht $needed Argumente, hier ${if (given == 1) "ist es 1" else "sind es $given"}. " +
            "Schreib es so: $call;"
    }

    override fun argumentNotConstant() =
        "Das muss eine Konstante sein: eine Zahl oder ein Name wie OUT_A, keine Variable."

    override fun argumentNotVariable() = "Das muss eine Variable sein, denn die Funktion ändert sie."

    override fun argumentNotSensor() = "Das muss ein Sensor sein: SENSOR_1, SENSOR_2 oder SENSOR_3."

    override fun argumentNotPointer() = "Das muss ein Zeiger sein oder die Adresse einer Variablen: &name."

    override fun nestedSub(name: String) = "Ein Unterprogramm kann keines aufrufen, und ${quoted(
        name,
    )} führt zu einem. Mach daraus eine Funktion: void $name()."

    override fun recursion(name: String) =
        "${quoted(name)} ruft sich selbst auf. Das kann der Stein nicht. Nimm eine Schleife."

    override fun subParameters(target: String) =
        "Ein Unterprogramm hat beim Ziel $target nichts in den Klammern. Nimm eine globale Variable oder eine Funktion: void."

    override fun tooManyTasks(limit: Int) = "Der Stein hat Platz für $limit Tasks. Das ist einer zu viel."

    override fun tooManySubs(limit: Int) =
        "Der Stein hat Platz für $limit Unterprogramme. Das ist eines zu viel. Mach aus einigen Funktionen: void."

    override fun pointerUnsupported() = "Zeiger brauchen Firmware 2.0. Dieses Programm ist für Firmware 1.0 (Ziel RCX)."

    override fun arrayUnsupported() = "Arrays brauchen Firmware 2.0. Dieses Programm ist für Firmware 1.0 (Ziel RCX)."

    override fun acquireUnsupported() = "acquire braucht Firmware 2.0. Dieses Programm ist für Firmware 1.0 (Ziel RCX)."

    override fun monitorUnsupported() = "monitor braucht Firmware 2.0. Dieses Programm ist für Firmware 1.0 (Ziel RCX)."

    private fun didYouMean(suggestion: String?) = suggestion?.let { "Meinst du ${quoted(it)}?" }
}

private object GermanCodeMessages : NqcCodeMessages {
    override fun noStorage() =
        "Der Stein hat keinen Platz für diese Variable. Er hat 32 für alle Tasks, mit Firmware 2.0 noch 16 für jeden."

    override fun noStorageInSharedSub() =
        "Mehrere Tasks rufen dieses Unterprogramm auf. Dann hat es Platz für 16 Variablen mit Firmware 2.0, für keine mit 1.0."

    override fun noStorageForSub(name: String) =
        "Die Variablen von ${quoted(name)} und von diesem Task passen zusammen nicht in den Stein. Nimm weniger."

    override fun noTemporaries() =
        "Der Stein hat keine Variablen mehr, um das zu berechnen. Nimm weniger Variablen oder teil die Zeile auf."

    override fun constantNeeded() = "Das muss eine Konstante sein: eine Zahl oder ein Name, dem #define eine gibt."

    override fun shiftNeedsConstant() = "Um wie viele Bits << und >> schieben, muss eine Konstante sein."

    override fun numberOutOfRange(number: Int) = "$number ist zu groß für den Stein. Zahlen gehen von -32768 bis 32767."

    override fun numberCut(number: Int, kept: Int) = "$number ist zu groß für den Stein. Daraus wird $kept."

    override fun caseOutOfRange() = "Ein case kann -32768 bis 32767 sein."

    override fun notAssignable() = "Dem hier kann man nichts zuweisen. Links vom = steht eine Variable."

    override fun notSteppable() = "Nur eine Variable lässt sich mit ++ oder -- ändern. Schreib x = x + 1;."

    override fun wrongSource() = "Dieser Befehl nimmt so einen Wert nicht an. Weise ihn zuerst einer Variablen zu."

    override fun nestedAcquire() =
        "Ein acquire kann nicht in einem anderen stehen. Schreib beides in eines: acquire(A | B)."

    override fun nestedMonitor() =
        "Ein monitor kann nicht in einem anderen stehen. Schreib beides in einen: monitor(A | B)."

    override fun continueOutsideLoop() =
        "continue macht mit der nächsten Runde einer Schleife weiter, aber hier ist keine."

    override fun breakOutsideLoop() = "break verlässt eine Schleife oder ein switch, aber hier ist keines."

    override fun caseOutsideSwitch() = "case und default gehören in ein switch."

    override fun duplicateCase(value: Int?) =
        if (value == null) "Dieses switch hat schon ein default." else "Dieses switch hat schon ein case $value."

    override fun wrongEventSource() =
        "Ereignisse kommen von SENSOR_1 bis SENSOR_3, Timer(0) bis Timer(3), Counter(0) bis Counter(2) oder Message()."

    override fun taskNumberUnknown() =
        "Mehrere Tasks rufen dieses Unterprogramm auf, also könnte __taskid jeder davon sein."

    override fun addressNotConstant() = "Für & muss die Nummer des Elements eine Konstante sein."

    override fun dividedByZero(isError: Boolean, isModulo: Boolean) = when {
        isError -> "Eine Zahl kann man nicht durch 0 teilen."
        isModulo -> "Hier wird durch 0 geteilt. Der Stein lässt die Division weg, also ergibt das nichts Sinnvolles."
        else -> "Hier wird durch 0 geteilt. Der Stein lässt die Division dann weg."
    }

    override fun wrongArraySize(limit: Int) = "Ein Array hat 1 bis $limit Elemente."

    override fun indexOutside(name: String, last: Int) =
        "${quoted(name)} hat die Elemente 0 bis $last. Dieses gehört zu einer anderen Variablen."

    override fun codeTooLong(limit: Int) =
        "Der Code wird länger als $limit Bytes. Ein Stein hat etwa 6000. Mach aus Funktionen Unterprogramme: sub."

    override fun memoryFull(bytes: Int, limit: Int) =
        "Das Programm hat $bytes Bytes, aber ein Stein hat nur $limit für alle Programme. Mach aus Funktionen " +
            "Unterprogramme: sub."

    override fun sensorNotSet(port: Int, call: String) =
        "Nirgends steht, was am Eingang $port steckt. Schreib am Anfang: $call;"

    override fun argumentRange(limit: ParameterLimit, value: Int) =
        "${nounOf(limit)} geht von ${limit.values.first} bis ${limit.values.last}, hier steht $value."

    private fun nounOf(limit: ParameterLimit) = when (limit) {
        ParameterLimit.OUTPUTS -> "Eine Summe aus OUT_A, OUT_B und OUT_C"
        ParameterLimit.POWER -> "Die Leistung"
        ParameterLimit.SOUND -> "Die Nummer eines Klangs"
        ParameterLimit.FREQUENCY -> "Eine Frequenz"
        ParameterLimit.TONE_TIME -> "Die Länge eines Tons"
        ParameterLimit.TIMER -> "Die Nummer eines Timers"
        ParameterLimit.COUNTER -> "Die Nummer eines Zählers"
        ParameterLimit.EVENT -> "Die Nummer eines Ereignisses"
        ParameterLimit.MESSAGE -> "Eine Nachricht"
        ParameterLimit.PROGRAM -> "Die Nummer eines Programms"
        ParameterLimit.PRIORITY -> "Eine Wichtigkeit"
        ParameterLimit.HOUR -> "Eine Stunde"
        ParameterLimit.MINUTE -> "Eine Minute"
        ParameterLimit.SLEEP_TIME -> "Die Zeit bis zum Ausschalten"
        ParameterLimit.WAIT -> "Eine Wartezeit"
        ParameterLimit.DISPLAY -> "Eine Ansicht der Anzeige"
        ParameterLimit.DECIMALS -> "Die Zahl der Nachkommastellen"
        ParameterLimit.SENSOR_TYPE -> "Die Art eines Sensors"
        ParameterLimit.ENTRIES -> "Die Zahl der Einträge"
    }
}
