package robotran.robolang.messages

/** The messages about runtime errors, one or two sentences each, implemented once per language. */
interface RunMessages {
    fun divisionByZero(dividend: String): String

    fun indexOutside(index: Int, size: Int): String

    fun tooManyCalls(name: String, limit: Int): String

    fun listsTooLarge(limit: Int): String

    /** On a brick that frees lists which are no longer in use. */
    fun listsInUseTooLarge(limit: Int): String

    fun negativeTime(value: String): String

    fun negativeCount(value: Int): String

    fun powerOutside(value: Int): String

    fun stepOfNothing(): String

    fun rootOfNegative(value: String): String

    fun powerOfNegative(base: String, exponent: String): String

    fun nothingReturned(name: String): String
}
