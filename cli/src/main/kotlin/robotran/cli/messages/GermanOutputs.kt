package robotran.cli.messages

import robotran.language.listed

internal object GermanOutputMessages : OutputMessages {
    override fun unwritable(name: String, why: String) = "$name konnte nicht geschrieben werden: $why"

    override fun diskFull(name: String) =
        "$name konnte nicht geschrieben werden: Der Datenträger ist voll. Was dort war, ist unverändert."

    override fun notAFileName(name: String) = "$name ist kein Name für eine Datei."

    override fun isSymbolicLink(name: String, target: String) =
        "$name ist eine Verknüpfung mit $target. Soll diese Datei geändert werden, nimm ihren eigenen Namen."

    override fun isInput(name: String) =
        "$name wird von diesem Befehl gelesen, deshalb wird dorthin nichts geschrieben. Wähle einen anderen Namen " +
            "für das Ergebnis."

    override fun writtenTwice(name: String) =
        "Zwei Ergebnisse kämen nach $name. Wähle für eines davon einen anderen Namen."

    override fun notAPicture(name: String, endings: List<String>) =
        "$name kann nicht geschrieben werden: Ein Bild kann ${listed(endings, "oder")} sein."

    override fun unexpected(problem: String) =
        "In Robotran selbst ist etwas schiefgegangen. Sag den Entwicklern bitte, was du gemacht hast, und dies: $problem"
}
