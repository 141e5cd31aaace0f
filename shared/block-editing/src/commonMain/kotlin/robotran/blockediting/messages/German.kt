package robotran.blockediting.messages

import robotran.blockediting.BlockDeed
import robotran.blockediting.BlockEditError
import robotran.language.listed
import robotran.language.quoted
import robotran.robolang.words.BlockGroup
import robotran.robolang.words.ValueKind

/** The messages in German. They address the pupil as "du". */
object GermanBlockMessages : BlockMessages {
    override fun group(group: BlockGroup) = when (group) {
        BlockGroup.DRIVE -> "Fahren"
        BlockGroup.PEN -> "Stift"
        BlockGroup.SENSE -> "Fühlen"
        BlockGroup.CONTROL -> "Ablauf"
        BlockGroup.NUMBERS -> "Zahlen"
        BlockGroup.LISTS -> "Listen"
        BlockGroup.OWN_COMMANDS -> "Eigene Befehle"
        BlockGroup.SHOW_AND_SOUND -> "Anzeige und Ton"
    }

    override fun editError(error: BlockEditError) = when (error) {
        BlockEditError.NotFound -> "Diesen Block gibt es nicht mehr. Versuch es noch einmal."
        BlockEditError.IntoItself -> "Ein Block passt nicht in sich selbst. Leg ihn an eine andere Stelle."

        BlockEditError.OnlyOutermost -> {
            "Dieser Block kann nicht in einem anderen Block stehen. Leg ihn über oder unter die anderen Blöcke."
        }

        BlockEditError.SettingOutsideRobot -> "Dieser Block gehört in einen \"robot\"-Block. Leg ihn dort hinein."

        BlockEditError.OnlySettings -> {
            "In einem \"robot\"-Block stehen nur Zeilen über den Stein und seine Sensoren. Leg den Block darunter."
        }

        BlockEditError.SecondRobot -> "Das Programm hat schon einen \"robot\"-Block. Ändere den."
        BlockEditError.TooDeep -> "Es wären zu viele Blöcke ineinander. Mach aus einigen davon einen eigenen Befehl."
        BlockEditError.TooLong -> "Das Programm würde zu lang. Lösch zuerst etwas."

        BlockEditError.LooseEnd -> {
            "Ein \"end\" oder \"else\" gehört zu keinem Block. Lösch oder verbessere es und versuch es noch einmal."
        }

        BlockEditError.NoSuchConstruct -> "Das geht nur mit einem Block, in dem andere stehen. Nimm einen anderen."
        BlockEditError.ElseExists -> "Dieses \"if\" hat schon ein \"else\". Leg deine Blöcke dort hinein."

        is BlockEditError.NoValue -> {
            error.mistake?.message ?: "${quoted(error.text)} ist kein Wert. Schreib eine Zahl, zum Beispiel \"20\"."
        }

        BlockEditError.NumberNeeded -> "Hier gehört eine Zahl hin, zum Beispiel \"20\" oder \"light\"."

        BlockEditError.ConditionNeeded -> {
            "Hier gehört eine Bedingung hin, zum Beispiel \"left bumper\" oder \"light < 40\"."
        }

        BlockEditError.ListNeeded -> "Hier gehört eine Liste hin, zum Beispiel \"[1, 2, 3]\"."
        BlockEditError.LastItem -> "Eine Liste hat mindestens eine Zahl. Ändere sie oder lösch den ganzen Block."
        BlockEditError.NoSuchForm -> "Aus diesem Block wird der andere nicht. Nimm einen neuen Block aus der Palette."
        is BlockEditError.NoChoice -> "Wähl ${listed(error.options.map(::quoted), "oder")}."

        is BlockEditError.NoName -> {
            "${quoted(
                error.name,
            )} kann kein Name sein. Nimm Buchstaben und Ziffern, zuerst einen Buchstaben, und kein Wort von Robolang."
        }

        is BlockEditError.NameTaken -> "Etwas anderes heißt schon ${quoted(error.name)}. Nimm einen anderen Namen."
        BlockEditError.NoText -> "Ein Text ist eine Zeile ohne Anführungszeichen. Lass sie weg."
        BlockEditError.NoFix -> "Hier lässt sich nichts von selbst verbessern. Ändere die Zeile selbst."
        BlockEditError.NoNote -> "Verbessere die Zeile, bevor du eine Notiz daran schreibst."
        BlockEditError.NothingToInsert -> "Es gibt nichts einzufügen. Kopier zuerst einen Block."

        BlockEditError.NoPlaceForValue -> {
            "Das ist ein Wert. Tippe erst auf die Stelle in einem Block, dann noch einmal hierauf, oder zieh ihn dorthin."
        }

        BlockEditError.NothingToTry -> {
            "Allein tut dieser Block nichts. Nimm einen, der etwas tut, zum Beispiel \"forward 20\"."
        }

        is BlockEditError.ValueUnknown -> {
            "${quoted(error.name)} hat nur im ganzen Programm einen Wert. Drück Starten oder setz eine Zahl ein."
        }

        is BlockEditError.Mistaken -> "Zeile ${error.line}: ${error.message}"
    }

    override fun level(level: Int) = "Ebene $level"

    override fun inside(count: Int) = when (count) {
        0 -> "nichts darin"
        1 -> "1 Block darin"
        else -> "$count Blöcke darin"
    }

    override fun isIn(line: String) = "in $line"

    override fun position(position: Int, count: Int) = "$position von $count"

    override fun blocks(count: Int) = if (count == 1) "1 Block" else "$count Blöcke"

    override fun deed(deed: BlockDeed, what: String) = when (deed) {
        BlockDeed.ADDED -> "Dazugekommen: $what"
        BlockDeed.MOVED -> "Verschoben: $what"
        BlockDeed.DOUBLED -> "Verdoppelt: $what"
        BlockDeed.DELETED -> "Gelöscht: $what"
        BlockDeed.CHANGED -> "Jetzt: $what"
    }

    override fun gone(what: String) = "Weg: $what"

    override fun undone(change: String?) = listOfNotNull("Rückgängig gemacht.", change).joinToString(" ")

    override fun redone(change: String?) = listOfNotNull("Wiederholt.", change).joinToString(" ")

    override fun note(text: String) = "Notiz: $text"

    override fun emptyLine() = "leere Zeile"

    override fun mistake(line: String, message: String?) =
        "Zeile mit einem Fehler: $line." + message?.let { " $it" }.orEmpty()

    override fun kind(kind: ValueKind) = when (kind) {
        ValueKind.NUMBER -> "Zahl"
        ValueKind.CONDITION -> "Bedingung"
        ValueKind.LIST -> "Liste"
        ValueKind.COLOUR -> "Farbe"
        ValueKind.UNKNOWN -> "Wert"
    }

    override fun choice(options: List<String>) = "wähl ${listed(options, "oder")}"
}
