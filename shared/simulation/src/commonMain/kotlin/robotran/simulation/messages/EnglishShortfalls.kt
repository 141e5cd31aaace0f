package robotran.simulation.messages

import robotran.language.listed
import robotran.world.TouchKind

/** What a run lacked for a goal, in English. */
internal object EnglishShortfallMessages : ShortfallMessages {
    override fun impossibleGoal() = "This world lacks what this goal is about."

    override fun notBegun() = "This one counts only when the one before it is done."

    override fun notReached(centimetres: String, area: String?) = "$centimetres cm short of ${name(area)}."

    override fun wholeNotReached(centimetres: String, area: String?) =
        "$centimetres cm more, and all of it would have been in ${name(area)}."

    override fun partlyOutside(centimetres: String, area: String?) =
        "A part of it stuck out of ${name(area)} by $centimetres cm."

    override fun reachedTooLate(seconds: String, area: String?) = "It got to ${name(area)}, but $seconds s too late."

    override fun leftAgain(time: String, centimetres: String, area: String?) =
        "It was in ${name(area)}, but left it at $time s. At the end it was $centimetres cm away."

    override fun entered(time: String, area: String?) = "It was in ${name(area)} at $time s."

    override fun left(time: String, area: String?) = "It left ${name(area)} at $time s."

    override fun touched(time: String, what: List<TouchKind>, name: String?): String {
        val thing = if (name == null) listed(what.map(::name), "and") else "${nameWithThe(what.first())} \"$name\""
        return "It touched $thing at $time s."
    }

    override fun inkTooShort(centimetres: String) = "The drawing is $centimetres cm too short."

    override fun inkTooLong(time: String, centimetres: String) =
        "The drawing was long enough at $time s. After that, $centimetres cm too much was drawn."

    override fun templateMissing(share: Int, wanted: Int) =
        "$share % of the template is drawn, and $wanted % is needed."

    override fun inkBesideTemplate(centimetres: String) =
        "$centimetres cm is drawn beside the template. That is too much."

    override fun lineNotReached(centimetres: String) =
        "The light sensor never found the line. It came as close as $centimetres cm."

    override fun lineLeft(time: String, share: Int) = "The line was left at $time s, after $share % of the way."

    override fun lineBeganAgain(time: String) =
        "The line was left at $time s and found again somewhere else, so the way began again there."

    override fun lineUnfinished(share: Int) = "$share % of the way along the line is done."

    override fun lineTooLate(seconds: String) = "The whole way along the line is done, but $seconds s too late."

    override fun stillRunning(time: String) = "The program was still running at $time s."

    override fun endedTooLate(seconds: String) = "The program came to its end $seconds s too late."

    override fun wasStopped(time: String) =
        "The program was stopped before its end. At $time s, it had not ended by itself."

    override fun hasFailed() = "The program had to stop because of a mistake."

    override fun notStarted() = "The program was not started."

    override fun displayBlank(wanted: String) = "The program showed nothing on the display, and \"$wanted\" is needed."

    override fun displayDiffered(wanted: String, last: String) =
        "The display showed \"$last\", and \"$wanted\" is needed."

    override fun displayNearly(wanted: String, nearest: String, time: String) =
        "At $time s the display showed \"$nearest\". That is near, but \"$wanted\" is needed."

    override fun displayChanged(wanted: String, last: String?, time: String): String {
        val now = if (last == null) "At the end it is empty." else "At the end it shows \"$last\"."
        return "The display showed \"$wanted\" up to $time s. $now"
    }

    override fun tooManyTones(played: Int, wanted: Int) =
        "$played tones were played, and $wanted ${if (wanted == 1) "is" else "are"} needed."

    override fun tonesMissing(played: Int, wanted: Int) = "$played of $wanted tones were played."

    override fun otherTones(played: Int, wanted: Int, others: Int, hertz: Int): String {
        val more = if (others == 1) "Another one was" else "$others others were"
        val first = if (others == 1) "it had" else "the first had"
        return "$played of $wanted tones were played. $more too high or too low: $first $hertz hertz."
    }

    private fun name(area: String?) = if (area == null) "the marked area" else "the area \"$area\""

    private fun name(kind: TouchKind): String = when (kind) {
        TouchKind.WALLS -> "a wall"
        TouchKind.BARRIERS -> "a barrier"
        TouchKind.BLOCKS -> "a block"
        TouchKind.ROBOTS -> "another robot"
    }

    private fun nameWithThe(kind: TouchKind): String = when (kind) {
        TouchKind.WALLS -> "the wall"
        TouchKind.BARRIERS -> "the barrier"
        TouchKind.BLOCKS -> "the block"
        TouchKind.ROBOTS -> "the robot"
    }
}
