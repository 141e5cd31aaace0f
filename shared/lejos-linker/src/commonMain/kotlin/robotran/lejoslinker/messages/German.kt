package robotran.lejoslinker.messages

import robotran.lejoslinker.image.PartKind
import robotran.tinyvm.messages.GermanTinyVmMessages

object GermanImageMessages : ImageMessages {
    override val tinyVm get() = GermanTinyVmMessages
    override val listing: ListingMessages get() = GermanListingMessages

    override fun tooManyClasses(count: Int, limit: Int) =
        "Dieses Programm braucht $count Klassen, die von leJOS mitgezählt. Ein Stein nimmt höchstens $limit: Nimm " +
            "weniger."

    override fun tooManyPrograms(count: Int, limit: Int) =
        "Das sind $count Programme. Ein Stein nimmt höchstens $limit auf einmal: Lass einige weg."

    override fun tooManyConstants(count: Int, limit: Int) =
        "Dieses Programm hat $count verschiedene Texte und große Zahlen, die von leJOS mitgezählt. Ein Stein " +
            "erreicht nur die ersten $limit: Nimm weniger Texte. Ganze Zahlen von -32768 bis 32767 zählen nicht mit."

    override fun tooManyStaticFields(count: Int, limit: Int) =
        "Dieses Programm hat $count statische Felder, die von leJOS mitgezählt. Ein Stein erreicht nur die ersten " +
            "$limit: Nimm weniger, oder leg Werte in ein Array."

    override fun tooManyStaticBytes(count: Int, limit: Int) =
        "Die statischen Felder dieses Programms brauchen $count Bytes. Ein Stein erreicht nur $limit: Nimm weniger, " +
            "oder leg Werte in ein Array."

    override fun tooManySignatures(count: Int, limit: Int) =
        "Dieses Programm hat $count Methoden, die sich in Namen oder Parametern unterscheiden. Ein Stein nimmt " +
            "höchstens $limit: Nimm weniger."

    override fun objectTooLarge(bytes: Int, limit: Int) =
        "Die Felder dieser Klasse brauchen $bytes Bytes. Ein Stein erreicht nur $limit: Nimm weniger, oder lege " +
            "Werte in ein Array."

    override fun imageTooLarge(bytes: Int, limit: Int) =
        "Dieses Programm braucht auf dem Stein $bytes Bytes, aber er hat nur Platz für $limit. Nimm weniger Klassen " +
            "von leJOS, oder schreib weniger Code."

    override fun littleMemory(bytes: Int) =
        "Auf dem Stein lässt dieses Programm nur $bytes Bytes für Objekte, Arrays und Texte. Der Speicher kann voll " +
            "werden: Schreib weniger Code, oder leg weniger davon an."

    override fun largeStep(variable: String, step: Int) =
        "So zählt der Stein nur Zahlen von -128 bis 127 dazu. Schreib \"${longForm(variable, step)}\"."

    override fun arraysOfObjectArrays() =
        "Der Stein kann Arrays von Objekten in einem Array nicht alle auf einmal anlegen. Leg zuerst das äußere " +
            "Array an, wie in \"new String[2][]\", und dann jedes innere in einer Schleife."

    override fun strangeCharacter(character: String) =
        "Der Stein kennt das Zeichen \"$character\" nicht. Nimm in Texten nur einfache Buchstaben, Ziffern und " +
            "Zeichen."
}

private object GermanListingMessages : ListingMessages {
    override fun parts(bytes: Int) = "Ein Abbild von $bytes Bytes:"

    override fun partName(kind: PartKind) = when (kind) {
        PartKind.MASTER_RECORD -> "Kopf"
        PartKind.CLASS_RECORDS -> "Einträge der Klassen"
        PartKind.STATIC_STATE -> "Werte der statischen Felder"
        PartKind.STATIC_FIELD_RECORDS -> "Einträge der statischen Felder"
        PartKind.CONSTANT_RECORDS -> "Einträge der Konstanten"
        PartKind.METHOD_RECORDS -> "Einträge der Methoden"
        PartKind.EXCEPTION_RECORDS -> "Einträge der Ausnahmen"
        PartKind.FIELD_TYPES -> "Typen der Felder"
        PartKind.CODE -> "Code"
        PartKind.CONSTANT_VALUES -> "Konstanten"
        PartKind.ENTRY_CLASSES -> "Programme"
    }

    override fun bytesAt(bytes: Int, offset: Int) = "$bytes ${if (bytes == 1) "Byte" else "Bytes"} ab $offset"

    override fun objectBytes(bytes: Int) = "Objekte von $bytes Bytes"

    override fun entryClasses() = "Programme:"

    override fun classes() = "Klassen und ihre Methoden:"

    override fun constants() = "Konstanten:"

    override fun staticFields() = "Statische Felder:"

    override fun signatures() = "Signaturen:"
}
