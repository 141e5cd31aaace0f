package robotran.robolang.messages

/** The warnings: the program can run, but probably not as intended. */
interface WarningMessages {
    fun unusedVariable(name: String): String

    fun neverReached(word: String): String

    fun busyLoop(): String

    fun fractionLost(division: String, result: Int): String

    /** The brick divides by [kept], the lower 16 bits of [divisor]. */
    fun divisorTooLarge(divisor: Int, kept: Int): String

    fun divisorTakenForZero(divisor: Int): String

    fun listInLoop(): String

    fun endlessRecursion(name: String): String
}
