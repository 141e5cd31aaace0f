package robotran.legofirmware.messages

import robotran.language.quoted

internal object AssemblyGerman : AssemblyMessages {
    override fun sourceTooLong(limit: Int) = "Dieser Text ist zu lang. Höchstens $limit Zeichen sind erlaubt."

    override fun unknownCharacter(text: String) = "Das Zeichen ${quoted(text)} hat hier keine Bedeutung."

    override fun unknownCommand(word: String, suggestion: String?) =
        "Einen Befehl ${quoted(word)} gibt es nicht." + suggestion?.let { " Meinst du ${quoted(it)}?" }.orEmpty()

    override fun missingCommand(text: String) =
        "Eine Zeile beginnt mit einem Befehl oder einer Marke, nicht mit ${quoted(text)}."

    override fun wrongNumberCount(form: String) = "Die Zahlen passen nicht zum Befehl. Er hat die Form ${quoted(form)}."

    override fun missingComma(text: String) = "Vor ${quoted(text)} fehlt ein Komma."

    override fun numberNeeded(text: String, name: String, form: String) = if (text.isEmpty()) {
        "Hier fehlt eine Zahl (${quoted(name)}). Die Form ist ${quoted(form)}."
    } else {
        "${quoted(text)} ist keine Zahl. Die Form ist ${quoted(form)}."
    }

    override fun numberOutOfRange(name: String, number: Int, least: Int, greatest: Int) =
        "Hier steht $number (${quoted(name)}). Erlaubt ist $least bis $greatest."

    override fun labelNeeded(text: String, form: String) = if (text.isEmpty()) {
        "Hier fehlt die Marke. Die Form ist ${quoted(form)}."
    } else {
        "${quoted(text)} ist keine Marke. Die Form ist ${quoted(form)}."
    }

    override fun unknownLabel(name: String, suggestion: String?) =
        "Eine Marke ${quoted(name)} gibt es nicht." + suggestion?.let { " Meinst du ${quoted(it)}?" }.orEmpty()

    override fun labelElsewhere(name: String) =
        "Die Marke ${quoted(name)} steht in einem anderen Task oder Unterprogramm. Ein Sprung bleibt in seinem eigenen."

    override fun labelTwice(name: String, firstLine: Int) = "Die Marke ${quoted(name)} steht schon in Zeile $firstLine."

    override fun tooFar(command: String, target: String, longForm: String?) =
        "${quoted(command)} reicht nicht bis ${quoted(target)}." +
            longForm?.let { " Nimm ${quoted(it)}, das reicht weiter und auch rückwärts." }.orEmpty()

    override fun outsideChunk(text: String) =
        "${quoted(text)} steht außerhalb eines Tasks. Beginne mit ${quoted("task 0")} und ende mit ${quoted("endt")}."

    override fun notClosed(frame: String, end: String) = "Zu diesem ${quoted(frame)} fehlt ${quoted(end)}."

    override fun wrongEnd(word: String, expected: String?) = if (expected == null) {
        "${quoted(word)} schließt nichts ab: Kein Task oder Unterprogramm ist offen."
    } else {
        "${quoted(word)} passt hier nicht. ${quoted(expected)} schließt ab, was offen ist."
    }

    override fun chunkTwice(frame: String, number: Int) = "${quoted("$frame $number")} gibt es schon."

    override fun codeTooLong(limit: Int) =
        "Dieser Task oder dieses Unterprogramm ist zu lang. Höchstens $limit Bytes sind erlaubt."

    override fun newerCommand(command: String) =
        "Nur Firmware 2.0 kennt ${quoted(command)}. Das Programm ist für Firmware 1.0."

    override fun newerSource(source: Int) =
        "Nur Firmware 2.0 kennt die Quelle $source. Das Programm ist für Firmware 1.0."

    override fun newerVariable(variable: Int) = "In Firmware 1.0 gibt es keine Variable $variable. Die letzte ist 31."

    override fun restrictedSource(command: String, source: Int) =
        "In Firmware 1.0 nimmt ${quoted(command)} die Quelle $source nicht. Setze den Wert zuerst in eine Variable."

    override fun unknownSource(source: Int) = "Ein RCX hat keine Quelle $source. Ihr Wert ist immer 0."

    override fun requestOnly(command: String) =
        "${quoted(command)} geht nur über Infrarotlicht. In einem Programm bewirkt es nichts."

    override fun noMainTask() = "Es gibt keinen Task 0. Deshalb startet die Taste Run nichts."
}
