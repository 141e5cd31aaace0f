package robotran.simulation.messages

import robotran.world.TouchKind

/**
 * What a run lacked for a goal, for pupils in one language, one function per sentence. Lengths are in centimetres, times
 * in seconds, both formatted. An area is the name of a mark; null if it has none.
 */
interface ShortfallMessages {
    fun impossibleGoal(): String

    fun notBegun(): String

    fun notReached(centimetres: String, area: String?): String

    /** All of it had to be inside, and no part was. */
    fun wholeNotReached(centimetres: String, area: String?): String

    fun partlyOutside(centimetres: String, area: String?): String

    fun reachedTooLate(seconds: String, area: String?): String

    /**
     * @param time when it left.
     * @param centimetres how far away it was at the end.
     */
    fun leftAgain(time: String, centimetres: String, area: String?): String

    /** @param time when it happened, as in all functions below. */
    fun entered(time: String, area: String?): String

    fun left(time: String, area: String?): String

    /**
     * @param what in the order of [TouchKind], never empty.
     * @param name the name of the thing; null if it has none.
     */
    fun touched(time: String, what: List<TouchKind>, name: String?): String

    fun inkTooShort(centimetres: String): String

    fun inkTooLong(time: String, centimetres: String): String

    /** Both in percent. */
    fun templateMissing(share: Int, wanted: Int): String

    fun inkBesideTemplate(centimetres: String): String

    fun lineNotReached(centimetres: String): String

    /** @param share how much of the way was done, in percent, as below. */
    fun lineLeft(time: String, share: Int): String

    /** It found the line again elsewhere, so that the way began again. */
    fun lineBeganAgain(time: String): String

    fun lineUnfinished(share: Int): String

    fun lineTooLate(seconds: String): String

    fun stillRunning(time: String): String

    fun endedTooLate(seconds: String): String

    fun wasStopped(time: String): String

    fun hasFailed(): String

    fun notStarted(): String

    fun displayBlank(wanted: String): String

    fun displayDiffered(wanted: String, last: String): String

    /** @param nearest what it showed at [time] that was most like the text. */
    fun displayNearly(wanted: String, nearest: String, time: String): String

    /**
     * @param last what it showed at last; null if nothing.
     * @param time when the text was replaced.
     */
    fun displayChanged(wanted: String, last: String?, time: String): String

    fun tooManyTones(played: Int, wanted: Int): String

    fun tonesMissing(played: Int, wanted: Int): String

    /** @param others how many tones had another pitch; the first had [hertz]. */
    fun otherTones(played: Int, wanted: Int, others: Int, hertz: Int): String
}
