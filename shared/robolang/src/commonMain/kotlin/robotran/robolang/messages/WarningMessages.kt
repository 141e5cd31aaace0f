package robotran.robolang.messages

/** What is told about programs that can run but are probably not meant so. */
interface WarningMessages {
    fun unusedVariable(name: String): String

    fun neverReached(word: String): String

    fun busyLoop(): String

    fun fractionLost(division: String, result: Int): String

    /** The brick takes [divisor] for [kept]. */
    fun divisorTooLarge(divisor: Int, kept: Int): String

    fun divisorTakenForZero(divisor: Int): String

    fun listInLoop(): String

    fun endlessRecursion(name: String): String
}
