package robotran.legofirmware.messages

import robotran.language.quoted

internal object ImageGerman : ImageMessages {
    override fun tooLarge(bytes: Int, limit: Int) =
        "Diese Datei hat $bytes Bytes. Ein RCX-Programm ist nie größer als $limit Bytes."

    override fun notAnImage() =
        "Das ist keine RCX-Programmdatei. Sie beginnt mit den Buchstaben RCXI und kommt von einem NQC-Compiler."

    override fun newerVersion(version: String) =
        "Diese Datei hat die Formatversion $version. Robotran liest Versionen bis 1.02."

    override fun otherBrick(name: String?) = if (name == null) {
        "Dieses Programm ist für einen unbekannten Baustein."
    } else {
        "Dieses Programm ist für den Baustein $name, nicht für einen RCX."
    }

    override fun unknownChunk(type: Int) =
        "Die Datei hat einen Teil unbekannter Art ($type). Erlaubt sind nur Tasks und Unterprogramme."

    override fun chunkCut(chunk: String?) =
        "Die Datei endet mitten in ${chunk ?: "einem Teil"}. Wurde sie vollständig kopiert?"

    override fun numberTooHigh(isTask: Boolean, number: Int, highest: Int) =
        "In der Datei steht ${chunk(isTask, number)}, aber die höchste Nummer ist $highest."

    override fun chunkTwice(chunk: String) = "In der Datei steht zweimal $chunk."

    override fun tooManySymbols(count: Int, limit: Int) = "Die Datei hat $count Namen. Höchstens $limit sind erlaubt."

    override fun namesCut(missing: Int) = if (missing == 1) {
        "Die Datei endet zu früh. Ein Name fehlt, aber das Programm kann laufen."
    } else {
        "Die Datei endet zu früh. $missing Namen fehlen, aber das Programm kann laufen."
    }

    override fun nameWithoutChunk(name: String) = "Der Name ${quoted(name)} gehört zu nichts in dieser Datei."

    override fun extraBytes(bytes: Int) = "Am Ende der Datei stehen $bytes Bytes zu viel. Sie werden übergangen."

    override fun largeProgram(bytes: Int, limit: Int) =
        "Das Programm hat $bytes Bytes. Ein echter RCX hat Platz für etwa $limit, für alle Programme zusammen."

    override fun noMainTask() = "Das Programm hat keinen Task 0. Deshalb startet die Taste Run nichts."

    override fun chunk(isTask: Boolean, number: Int) = if (isTask) "Task $number" else "Unterprogramm $number"
}
