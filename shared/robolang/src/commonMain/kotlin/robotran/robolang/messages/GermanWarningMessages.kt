package robotran.robolang.messages

import robotran.language.quoted

/** What is told in German about what is probably not meant so. */
internal object GermanWarningMessages : WarningMessages {
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
