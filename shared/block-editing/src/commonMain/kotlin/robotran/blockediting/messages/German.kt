package robotran.blockediting.messages

import robotran.blockediting.BlockDeed
import robotran.blockediting.BlockGroup
import robotran.blockediting.BlockRefusal
import robotran.language.listed
import robotran.language.quoted
import robotran.robolang.outline.ValueKind

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

    override fun refusal(refusal: BlockRefusal) = when (refusal) {
        BlockRefusal.NotFound -> {
            "Diesen Block gibt es nicht mehr. Versuch es noch einmal."
        }

        BlockRefusal.IntoItself -> {
            "Ein Block passt nicht in sich selbst. Leg ihn an eine andere Stelle."
        }

        BlockRefusal.OnlyOutermost -> {
            "Dieser Block kann nicht in einem anderen Block stehen. Leg ihn über oder unter die anderen Blöcke."
        }

        BlockRefusal.SettingOutsideRobot -> {
            "Dieser Block gehört in einen \"robot\"-Block. Leg ihn dort hinein."
        }

        BlockRefusal.OnlySettings -> {
            "In einem \"robot\"-Block stehen nur Zeilen über den Lichtsensor. Leg den Block darunter."
        }

        BlockRefusal.SecondRobot -> {
            "Das Programm hat schon einen \"robot\"-Block. Ändere den."
        }

        BlockRefusal.TooDeep -> {
            "Es wären zu viele Blöcke ineinander. Mach aus einigen davon einen eigenen Befehl."
        }

        BlockRefusal.TooLong -> {
            "Das Programm würde zu lang. Lösch zuerst etwas."
        }

        BlockRefusal.LooseEnd -> {
            "Ein \"end\" oder \"else\" gehört zu keinem Block. Lösch oder verbessere es und versuch es noch einmal."
        }

        BlockRefusal.NoSuchConstruct -> {
            "Das geht nur mit einem Block, in dem andere stehen. Nimm einen anderen."
        }

        BlockRefusal.ElseExists -> {
            "Dieses \"if\" hat schon ein \"else\". Leg deine Blöcke dort hinein."
        }

        is BlockRefusal.NoValue -> {
            refusal.mistake?.message ?: "${quoted(refusal.text)} ist kein Wert. Schreib eine Zahl, zum Beispiel \"20\"."
        }

        BlockRefusal.NumberNeeded -> {
            "Hier gehört eine Zahl hin, zum Beispiel \"20\" oder \"light\"."
        }

        BlockRefusal.ConditionNeeded -> {
            "Hier gehört eine Bedingung hin, zum Beispiel \"left bumper\" oder \"light < 40\"."
        }

        BlockRefusal.ListNeeded -> {
            "Hier gehört eine Liste hin, zum Beispiel \"[1, 2, 3]\"."
        }

        BlockRefusal.LastItem -> {
            "Eine Liste hat mindestens eine Zahl. Ändere sie oder lösch den ganzen Block."
        }

        BlockRefusal.NoSuchForm -> {
            "Aus diesem Block wird der andere nicht. Nimm einen neuen Block aus der Palette."
        }

        is BlockRefusal.NoChoice -> {
            "Wähl ${listed(refusal.options.map(::quoted), "oder")}."
        }

        is BlockRefusal.NoName -> {
            "${quoted(
                refusal.name,
            )} kann kein Name sein. Nimm Buchstaben und Ziffern, zuerst einen Buchstaben, und kein Wort von Robolang."
        }

        is BlockRefusal.NameTaken -> {
            "Etwas anderes heißt schon ${quoted(refusal.name)}. Nimm einen anderen Namen."
        }

        BlockRefusal.NoText -> {
            "Ein Text ist eine Zeile ohne Anführungszeichen. Lass sie weg."
        }

        BlockRefusal.NoFix -> {
            "Hier lässt sich nichts von selbst verbessern. Ändere die Zeile selbst."
        }

        BlockRefusal.NoNote -> {
            "Verbessere die Zeile, bevor du eine Notiz daran schreibst."
        }

        BlockRefusal.NothingToInsert -> {
            "Es gibt nichts einzufügen. Kopier zuerst einen Block."
        }

        BlockRefusal.NoPlaceForValue -> {
            "Das ist ein Wert. Tippe erst auf die Stelle in einem Block, dann noch einmal hierauf, oder zieh ihn dorthin."
        }

        BlockRefusal.NothingToTry -> {
            "Allein tut dieser Block nichts. Nimm einen, der etwas tut, zum Beispiel \"forward 20\"."
        }

        is BlockRefusal.ValueUnknown -> {
            "${quoted(refusal.name)} hat nur im ganzen Programm einen Wert. Drück Starten oder setz eine Zahl ein."
        }

        is BlockRefusal.Mistaken -> {
            "Zeile ${refusal.line}: ${refusal.message}"
        }
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

    override fun note(text: String) = "Notiz: $text"

    override fun emptyLine() = "leere Zeile"

    override fun mistake(line: String, message: String?) =
        "Zeile mit einem Fehler: $line." + message?.let { " $it" }.orEmpty()

    override fun kind(kind: ValueKind) = when (kind) {
        ValueKind.NUMBER -> "Zahl"
        ValueKind.CONDITION -> "Bedingung"
        ValueKind.LIST -> "Liste"
        ValueKind.UNKNOWN -> "Wert"
    }

    override fun choice(options: List<String>) = "wähl ${listed(options, "oder")}"
}
