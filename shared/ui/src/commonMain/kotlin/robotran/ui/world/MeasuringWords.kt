package robotran.ui.world

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.*
import robotran.ui.runbar.oneDecimal
import robotran.ui.sheet.distance
import robotran.workshop.measuring.MeasuredThing
import robotran.workshop.measuring.Measuring
import robotran.workshop.measuring.MeasuringEnd
import robotran.workshop.measuring.SnappedPlace
import kotlin.math.abs

/** The length and the angle on the sheet, as a program has them. */
internal class MeasuringLabels(val length: String, val angle: String)

@Composable
internal fun measuringLabels(measuring: Measuring): MeasuringLabels {
    val angle = if (measuring.degrees < 0) Res.string.measure_right else Res.string.measure_left
    return MeasuringLabels(
        stringResource(Res.string.measure_length, measured(measuring.centimetres)),
        stringResource(angle, measured(abs(measuring.degrees))),
    )
}

/** The same in a sentence, for screen readers. */
@Composable
internal fun measuringWords(measuring: Measuring): String {
    val turn = if (measuring.degrees < 0) Res.string.measure_said_right else Res.string.measure_said_left
    return stringResource(
        Res.string.measure_result,
        measured(measuring.centimetres),
        stringResource(turn, measured(abs(measuring.degrees))),
    )
}

/** What [end] is, and where. */
@Composable
internal fun describeEnd(end: MeasuringEnd, measuring: Measuring, things: List<SnappedPlace>): String {
    val place = measuring.placeOf(end)
    val thing = things.firstOrNull { distance(it.point, place) < SAME_CENTIMETRES }?.thing
    val where = thing?.let { "${stringResource(it.words)}, ${placeWords(place)}" } ?: placeWords(place)
    return stringResource(end.words, where)
}

/** A number as it is written in a program: with one decimal, unless that is 0. */
internal fun measured(number: Double): String = oneDecimal(number).removeSuffix(".0")

private val MeasuringEnd.words: StringResource
    get() = when (this) {
        MeasuringEnd.FROM -> Res.string.measure_from
        MeasuringEnd.TO -> Res.string.measure_to
        MeasuringEnd.BASE -> Res.string.measure_base
    }

private val MeasuredThing.words: StringResource
    get() = when (this) {
        MeasuredThing.ROBOT -> Res.string.measure_thing_robot
        MeasuredThing.GOAL -> Res.string.measure_thing_goal
        MeasuredThing.LAMP -> Res.string.measure_thing_lamp
        MeasuredThing.BLOCK -> Res.string.measure_thing_block
        MeasuredThing.BARRIER -> Res.string.measure_thing_barrier
        MeasuredThing.TEMPLATE -> Res.string.measure_thing_template
    }

private const val SAME_CENTIMETRES = 0.05
