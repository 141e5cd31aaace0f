package robotran.simulation

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import robotran.simulation.messages.ShortfallMessages
import robotran.simulation.messages.sentenceFor
import robotran.simulation.state.ForbiddenTouch
import robotran.simulation.state.GoalShortfall
import robotran.simulation.state.InkShortfall
import robotran.simulation.state.LineShortfall
import robotran.simulation.state.PlaceShortfall
import robotran.simulation.state.ProgramShortfall
import robotran.world.Thousandths
import robotran.world.geometry.Point
import robotran.world.roundToThousandths

/**
 * A [GoalShortfall] in a report. What does not apply is omitted.
 *
 * @property sentence what the pupil reads.
 * @property seconds virtual time of the moment that mattered.
 * @property place the spot on the sheet that mattered.
 * @property line the program's line at that moment, from 1.
 * @property file the file of that line, if the program has several.
 * @property centimetres how much was missing or too much.
 * @property lateSeconds how much too late it was.
 * @property share how much was done, 0..1.
 */
@Serializable
data class ReportedShortfall(
    val kind: ReportedShortfallKind,
    val sentence: String,
    val seconds: Thousandths? = null,
    val place: ReportedPlace? = null,
    val line: Int? = null,
    val file: String? = null,
    val centimetres: Thousandths? = null,
    val lateSeconds: Thousandths? = null,
    val share: Thousandths? = null,
) {
    companion object {
        fun of(shortfall: GoalShortfall, messages: ShortfallMessages): ReportedShortfall {
            if (shortfall is GoalShortfall.PartNotMet) return of(shortfall.shortfall, messages)
            val moment = shortfall.moment
            return ReportedShortfall(
                kind = kindOf(shortfall),
                sentence = messages.sentenceFor(shortfall),
                seconds = moment?.milliseconds?.let(::seconds),
                place = shortfall.place?.let(ReportedPlace::of),
                line = moment?.sourceLine?.takeIf { it > 0 },
                file = moment?.sourceFile,
                centimetres = centimetresOf(shortfall)?.let(::roundToThousandths),
                lateSeconds = lateMillisecondsOf(shortfall)?.let(::seconds),
                share = shareOf(shortfall)?.let(::roundToThousandths),
            )
        }

        private fun seconds(milliseconds: Long) = roundToThousandths(milliseconds / MILLISECONDS_PER_SECOND)

        private const val MILLISECONDS_PER_SECOND = 1000.0
    }
}

/** A [Point] in a report. */
@Serializable
data class ReportedPlace(val x: Thousandths, val y: Thousandths) {
    companion object {
        fun of(point: Point) = ReportedPlace(roundToThousandths(point.x), roundToThousandths(point.y))
    }
}

/** The kind of a [GoalShortfall] in a report; a group has that of its decisive part. */
@Serializable
enum class ReportedShortfallKind {
    @SerialName("impossible")
    IMPOSSIBLE,

    @SerialName("not-begun")
    NOT_BEGUN,

    @SerialName("not-reached")
    NOT_REACHED,

    @SerialName("partly-outside")
    PARTLY_OUTSIDE,

    @SerialName("too-late")
    TOO_LATE,

    @SerialName("left-again")
    LEFT_AGAIN,

    @SerialName("entered")
    ENTERED,

    @SerialName("left")
    LEFT,

    @SerialName("touched")
    TOUCHED,

    @SerialName("too-short")
    TOO_SHORT,

    @SerialName("too-long")
    TOO_LONG,

    @SerialName("template-missing")
    TEMPLATE_MISSING,

    @SerialName("ink-beside-template")
    INK_BESIDE_TEMPLATE,

    @SerialName("unfinished")
    UNFINISHED,

    @SerialName("still-running")
    STILL_RUNNING,

    @SerialName("interrupted")
    INTERRUPTED,

    @SerialName("not-started")
    NOT_STARTED,

    @SerialName("display-differed")
    DISPLAY_DIFFERED,

    @SerialName("display-changed")
    DISPLAY_CHANGED,

    @SerialName("tones-missing")
    TONES_MISSING,

    @SerialName("too-many-tones")
    TOO_MANY_TONES,
}

private fun kindOf(shortfall: GoalShortfall): ReportedShortfallKind = when (shortfall) {
    GoalShortfall.ImpossibleGoal -> ReportedShortfallKind.IMPOSSIBLE
    GoalShortfall.NotBegun -> ReportedShortfallKind.NOT_BEGUN
    is GoalShortfall.PartNotMet -> kindOf(shortfall.shortfall)
    is PlaceShortfall.NotReached, is LineShortfall.NotReached -> ReportedShortfallKind.NOT_REACHED
    is PlaceShortfall.PartlyOutside -> ReportedShortfallKind.PARTLY_OUTSIDE
    is PlaceShortfall.ReachedTooLate, is LineShortfall.TooLate -> ReportedShortfallKind.TOO_LATE
    is PlaceShortfall.LeftAgain -> ReportedShortfallKind.LEFT_AGAIN
    is PlaceShortfall.Entered -> ReportedShortfallKind.ENTERED
    is PlaceShortfall.Left, is LineShortfall.Left -> ReportedShortfallKind.LEFT
    is ForbiddenTouch -> ReportedShortfallKind.TOUCHED
    is InkShortfall.TooShort -> ReportedShortfallKind.TOO_SHORT
    is InkShortfall.TooLong -> ReportedShortfallKind.TOO_LONG
    is InkShortfall.TemplateMissing -> ReportedShortfallKind.TEMPLATE_MISSING
    is InkShortfall.InkBesideTemplate -> ReportedShortfallKind.INK_BESIDE_TEMPLATE
    is LineShortfall.Unfinished -> ReportedShortfallKind.UNFINISHED
    is ProgramShortfall.StillRunning -> ReportedShortfallKind.STILL_RUNNING
    is ProgramShortfall.EndedTooLate -> ReportedShortfallKind.TOO_LATE
    is ProgramShortfall.Interrupted -> ReportedShortfallKind.INTERRUPTED
    ProgramShortfall.NotStarted -> ReportedShortfallKind.NOT_STARTED
    is ProgramShortfall.DisplayDiffered -> ReportedShortfallKind.DISPLAY_DIFFERED
    is ProgramShortfall.DisplayChanged -> ReportedShortfallKind.DISPLAY_CHANGED
    is ProgramShortfall.TonesMissing -> ReportedShortfallKind.TONES_MISSING
    is ProgramShortfall.TooManyTones -> ReportedShortfallKind.TOO_MANY_TONES
}

private fun centimetresOf(shortfall: GoalShortfall): Double? = when (shortfall) {
    is PlaceShortfall.NotReached -> shortfall.centimetres
    is PlaceShortfall.PartlyOutside -> shortfall.centimetres
    is PlaceShortfall.LeftAgain -> shortfall.centimetres
    is PlaceShortfall.Left -> shortfall.centimetres
    is InkShortfall.TooShort -> shortfall.centimetres
    is InkShortfall.TooLong -> shortfall.centimetres
    is InkShortfall.InkBesideTemplate -> shortfall.centimetres
    is LineShortfall.NotReached -> shortfall.centimetres
    is LineShortfall.Left -> shortfall.centimetres
    is LineShortfall.Unfinished -> shortfall.centimetres
    else -> null
}

private fun lateMillisecondsOf(shortfall: GoalShortfall): Long? = when (shortfall) {
    is PlaceShortfall.ReachedTooLate -> shortfall.milliseconds
    is LineShortfall.TooLate -> shortfall.milliseconds
    is ProgramShortfall.EndedTooLate -> shortfall.milliseconds
    else -> null
}

private fun shareOf(shortfall: GoalShortfall): Double? = when (shortfall) {
    is InkShortfall.TemplateMissing -> shortfall.share
    is LineShortfall.Left -> shortfall.share
    is LineShortfall.Unfinished -> shortfall.share
    is ProgramShortfall.TonesMissing -> shortfall.played.toDouble() / shortfall.wanted
    else -> null
}
