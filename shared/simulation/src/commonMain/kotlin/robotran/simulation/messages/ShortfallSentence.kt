package robotran.simulation.messages

import robotran.simulation.state.ForbiddenTouch
import robotran.simulation.state.GoalShortfall
import robotran.simulation.state.InkShortfall
import robotran.simulation.state.LineShortfall
import robotran.simulation.state.PlaceShortfall
import robotran.simulation.state.ProgramShortfall
import robotran.simulation.state.RunMoment
import kotlin.math.ceil

/** What a run lacked, in a sentence or two for the pupil. For a group, it is about the part that was decisive. */
fun ShortfallMessages.sentenceFor(shortfall: GoalShortfall): String = when (shortfall) {
    GoalShortfall.ImpossibleGoal -> impossibleGoal()
    GoalShortfall.NotBegun -> notBegun()
    is GoalShortfall.PartNotMet -> sentenceFor(shortfall.shortfall)
    is PlaceShortfall -> sentenceFor(shortfall)
    is ForbiddenTouch -> touched(time(shortfall.moment), shortfall.what.sorted(), shortfall.name)
    is InkShortfall -> sentenceFor(shortfall)
    is LineShortfall -> sentenceFor(shortfall)
    is ProgramShortfall -> sentenceFor(shortfall)
}

private fun ShortfallMessages.sentenceFor(shortfall: PlaceShortfall): String = with(shortfall) {
    when (this) {
        is PlaceShortfall.NotReached -> notReached(amount(centimetres), area)

        is PlaceShortfall.PartlyOutside -> if (wasPartlyInside) {
            partlyOutside(amount(centimetres), area)
        } else {
            wholeNotReached(amount(centimetres), area)
        }

        is PlaceShortfall.ReachedTooLate -> reachedTooLate(seconds(milliseconds), area)
        is PlaceShortfall.LeftAgain -> leftAgain(time(moment), amount(centimetres), area)
        is PlaceShortfall.Entered -> entered(time(moment), area)
        is PlaceShortfall.Left -> left(time(moment), area)
    }
}

private fun ShortfallMessages.sentenceFor(shortfall: InkShortfall): String = with(shortfall) {
    when (this) {
        is InkShortfall.TooShort -> inkTooShort(amount(centimetres))
        is InkShortfall.TooLong -> inkTooLong(time(moment), amount(centimetres))
        is InkShortfall.TemplateMissing -> templateMissing(wholePercent(share), wholePercent(wanted))
        is InkShortfall.InkBesideTemplate -> inkBesideTemplate(amount(centimetres))
    }
}

private fun ShortfallMessages.sentenceFor(shortfall: LineShortfall): String = with(shortfall) {
    when (this) {
        is LineShortfall.NotReached -> lineNotReached(amount(centimetres))

        is LineShortfall.Left -> if (cameBack) {
            lineBeganAgain(time(moment))
        } else {
            lineLeft(time(moment), wholePercent(share))
        }

        is LineShortfall.Unfinished -> lineUnfinished(wholePercent(share))
        is LineShortfall.TooLate -> lineTooLate(seconds(milliseconds))
    }
}

private fun ShortfallMessages.sentenceFor(shortfall: ProgramShortfall): String = with(shortfall) {
    when (this) {
        is ProgramShortfall.StillRunning -> stillRunning(time(moment))
        is ProgramShortfall.EndedTooLate -> endedTooLate(seconds(milliseconds))
        is ProgramShortfall.Interrupted -> if (hasFailed) hasFailed() else wasStopped(time(moment))
        ProgramShortfall.NotStarted -> notStarted()
        is ProgramShortfall.DisplayDiffered -> displaySentence(this)
        is ProgramShortfall.DisplayChanged -> displayChanged(wanted, last, time(moment))
        is ProgramShortfall.TooManyTones -> tooManyTones(played, wanted)
        is ProgramShortfall.TonesMissing -> toneSentence(this)
    }
}

private fun ShortfallMessages.displaySentence(shortfall: ProgramShortfall.DisplayDiffered): String {
    val last = shortfall.last
    val nearest = shortfall.nearest
    val moment = shortfall.moment
    return when {
        nearest == null || moment == null -> displayBlank(shortfall.wanted)
        last == null || nearest !in last -> displayNearly(shortfall.wanted, nearest, time(moment))
        else -> displayDiffered(shortfall.wanted, nearest)
    }
}

private fun ShortfallMessages.toneSentence(shortfall: ProgramShortfall.TonesMissing): String = with(shortfall) {
    val hertz = otherHertz
    if (hertz == null) {
        tonesMissing(played, wanted)
    } else {
        otherTones(played, wanted, others, (hertz + HALF).toInt())
    }
}

/** Rounded up, so that it is enough for the goal; never nothing. */
private fun amount(centimetres: Double): String = number(maxOf(1.0, ceil(centimetres * TENTHS - TINY)) / TENTHS)

/** The moment, to the tenth of a second in which it is. */
private fun time(moment: RunMoment): String = number(moment.milliseconds / MILLISECONDS_PER_TENTH / TENTHS)

/** Rounded up like an amount. */
private fun seconds(milliseconds: Long): String = amount(milliseconds / MILLISECONDS_PER_SECOND)

/** Rounded down, so that what is not complete never looks complete. */
private fun wholePercent(share: Double): Int = (share * PERCENT + TINY).toInt()

private const val HALF = 0.5
private const val TENTHS = 10.0
private const val PERCENT = 100.0
private const val MILLISECONDS_PER_TENTH = 100L
private const val MILLISECONDS_PER_SECOND = 1000.0

/** Far below anything that is shown, but above the errors of a few floating-point operations. */
private const val TINY = 1e-6
