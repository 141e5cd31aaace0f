package robotran.ui.world

import androidx.compose.runtime.Composable
import robotran.language.Language
import robotran.ui.sheet.distance
import robotran.ui.world.texts.SheetTexts
import robotran.uikit.*
import robotran.workshop.measuring.MeasuredThing
import robotran.workshop.measuring.Measuring
import robotran.workshop.measuring.MeasuringEnd
import robotran.workshop.measuring.SnappedPlace
import kotlin.math.abs

/** The length and the angle on the sheet, as a program has them. */
internal class MeasuringLabels(val length: String, val angle: String)

@Composable
internal fun measuringLabels(measuring: Measuring): MeasuringLabels {
    val angle = if (measuring.degrees < 0) SheetTexts::measureRight else SheetTexts::measureLeft
    return MeasuringLabels(
        SheetTexts.measureLength(spoken, measured(measuring.centimetres)),
        angle(spoken, measured(abs(measuring.degrees))),
    )
}

/** The same in a sentence, for screen readers. */
@Composable
internal fun measuringWords(measuring: Measuring): String {
    val turn = if (measuring.degrees < 0) SheetTexts::measureSaidRight else SheetTexts::measureSaidLeft
    return SheetTexts.measureResult(
        spoken,
        measured(measuring.centimetres),
        turn(spoken, measured(abs(measuring.degrees))),
    )
}

/** What [end] is, and where. */
@Composable
internal fun describeEnd(end: MeasuringEnd, measuring: Measuring, things: List<SnappedPlace>): String {
    val place = measuring.placeOf(end)
    val thing = things.firstOrNull { distance(it.point, place) < SAME_CENTIMETRES }?.thing
    val where = thing?.let { "${it.words(spoken)}, ${placeWords(place)}" } ?: placeWords(place)
    return end.words(spoken, where)
}

/** A number as it is written in a program: with one decimal, unless that is 0. */
internal fun measured(number: Double): String = oneDecimal(number).removeSuffix(".0")

private val MeasuringEnd.words: (Language, String) -> String
    get() = when (this) {
        MeasuringEnd.FROM -> SheetTexts::measureFrom
        MeasuringEnd.TO -> SheetTexts::measureTo
        MeasuringEnd.BASE -> SheetTexts::measureBase
    }

private val MeasuredThing.words: Label
    get() = when (this) {
        MeasuredThing.ROBOT -> SheetTexts::measureThingRobot
        MeasuredThing.GOAL -> SheetTexts::measureThingGoal
        MeasuredThing.LAMP -> SheetTexts::measureThingLamp
        MeasuredThing.BLOCK -> SheetTexts::measureThingBlock
        MeasuredThing.BARRIER -> SheetTexts::measureThingBarrier
        MeasuredThing.TEMPLATE -> SheetTexts::measureThingTemplate
    }

private const val SAME_CENTIMETRES = 0.05
