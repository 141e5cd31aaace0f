package robotran.workshop.platform

/** The clock on the wall. Nothing of a run ever sees it; it says when a work was kept. */
interface WallClock {
    /** Milliseconds since 1970. */
    val now: Long

    /**
     * When [milliseconds] was, as people write it who speak [language] (`en`), short: today's times without their day.
     */
    fun describe(milliseconds: Long, language: String): String
}

/** A clock that shows what it is told: for tests. */
class FixedClock(override var now: Long = 0) : WallClock {
    override fun describe(milliseconds: Long, language: String): String = "${milliseconds / MINUTE} min"

    private companion object {
        const val MINUTE = 60_000L
    }
}
