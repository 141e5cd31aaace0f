package robotran.workshop.platform

/** Real time, for timestamps of saved projects. Runs never use it. */
interface WallClock {
    /** Milliseconds since 1970. */
    val now: Long

    /** Formats [milliseconds] in short form for [language] (`en`); times of today omit the date. */
    fun describe(milliseconds: Long, language: String): String

    /** The date of [milliseconds] in words, in [language] (`en`). */
    fun date(milliseconds: Long, language: String): String
}

/** A clock with a settable time, for tests. */
class FixedClock(override var now: Long = 0) : WallClock {
    override fun describe(milliseconds: Long, language: String): String = "${milliseconds / MINUTE} min"

    override fun date(milliseconds: Long, language: String): String = "day ${milliseconds / MINUTE / MINUTES_PER_DAY}"

    private companion object {
        const val MINUTE = 60_000L
        const val MINUTES_PER_DAY = 1_440
    }
}
