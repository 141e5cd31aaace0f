package robotran.robolang.messages

import robotran.language.quoted

/** The messages in German, with the terms of [GermanRobolangMessages]. */
object GermanNqcTranslationMessages : NqcTranslationMessages {
    override fun otherBrick() = "NQC ist für einen RCX, aber das hier ist für einen NXT."

    override fun decimal() =
        "NQC hat keine Kommazahlen. Es kann sie nur übernehmen, wo sie nach forward, turn, wait oder play stehen " +
            "oder mit timer oder battery verglichen werden."

    override fun list() = "Listen lassen sich nicht nach NQC übertragen."

    override fun numberTooLarge(number: Int) = "$number ist zu groß für NQC. Seine Zahlen gehen von -32768 bis 32767."

    override fun text() = "Die Firmware von LEGO kann keine Texte zeigen, nur Zahlen."

    override fun clearScreen() = "Die Firmware von LEGO kann ihre Anzeige nicht löschen. Sie zeigt stattdessen die Uhr."

    override fun button() = "Ein Programm für die Firmware von LEGO kann die Tasten nicht lesen."

    override fun whenever() = "whenever lässt sich nicht nach NQC übertragen. Schreib dort einen Task mit acquire."

    override fun recursion(name: String) =
        "${quoted(name)} ruft sich selbst auf, und das kann die Firmware von LEGO nicht."

    override fun builtIn(name: String) = "NQC hat keine Funktion ${quoted(name)}."

    override fun unknownStep() = "Für NQC muss die Schrittweite einer Schleife als Zahl dastehen."

    override fun tooLong() = "Die Firmware von LEGO kann höchstens 327 Sekunden am Stück warten."

    override fun alwaysCalled() =
        "In NQC wird diese Funktion auch dann aufgerufen, wenn die linke Seite von and oder or schon entscheidet."
}
