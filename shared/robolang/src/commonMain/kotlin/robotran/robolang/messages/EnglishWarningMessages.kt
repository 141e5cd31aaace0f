package robotran.robolang.messages

import robotran.language.quoted

/** What is told in English about what is probably not meant so. */
internal object EnglishWarningMessages : WarningMessages {
    override fun unusedVariable(name: String) = "${quoted(name)} is never used."

    override fun neverReached(word: String) = "This is never done, because of the ${quoted(word)} before it."

    override fun busyLoop() = "This goes on forever without moving, waiting or sensing, and only keeps the brick busy."

    override fun fractionLost(division: String, result: Int) =
        "Dividing whole numbers gives a whole number: ${quoted(division)} is $result. Write one of them with a point " +
            "for more."

    override fun divisorTooLarge(divisor: Int, kept: Int) =
        "The brick divides only by numbers from -32768 to 32767. It takes $divisor for $kept."

    override fun listInLoop() =
        "This makes a new list again and again, and the brick never gets its memory back. Make the list once, at the " +
            "top."

    override fun divisorTakenForZero(divisor: Int) =
        "The brick divides only by numbers from -32768 to 32767. It takes $divisor for 0 and stops."

    override fun endlessRecursion(name: String) = "${quoted(name)} always calls itself, so it never comes to its end."
}
