package robotran.worldediting

import robotran.editing.Field
import robotran.editing.NumberSpec
import robotran.editing.TextSpec
import robotran.editing.Words
import robotran.editing.WorldEditorTexts
import robotran.editing.isValidText
import robotran.editing.optionalNumber
import robotran.editing.ungrouped
import robotran.json.nearestDecimal
import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.HasActor
import robotran.world.HasLine
import robotran.world.HasRegion
import robotran.world.HasTimeLimit
import robotran.world.TouchKind
import robotran.world.World
import robotran.world.WorldLimits

/**
 * The fields of a goal in display order: those of its facets, and between them those of its kind. The robot or block,
 * the line and the region are not included, because they depend on what is on the paper.
 *
 * @param timeLimit the world's time limit in seconds.
 */
fun fieldsOf(condition: GoalCondition, timeLimit: Int = World.DEFAULT_TIME_LIMIT): List<Field<GoalCondition>> =
    buildList {
        if (condition is HasRegion) {
            add(Field.Flag("field-whole", WorldEditorTexts::whole, condition.whole, condition::withWhole))
        }
        addAll(ownFieldsOf(condition))
        if (condition is HasTimeLimit) {
            val number = "field-seconds" to WorldEditorTexts::seconds
            val within = condition.within?.toDouble()
            add(
                optionalNumber(
                    "field-within" to WorldEditorTexts::within,
                    number,
                    within,
                    timeLimit.toDouble(),
                    SECONDS,
                ) {
                    condition.withTimeLimit(it?.toInt())
                },
            )
        }
    }

private fun ownFieldsOf(condition: GoalCondition): List<Field<GoalCondition>> = with(condition) {
    when (this) {
        is GoalCondition.Reach -> listOf(Field.Flag("field-stays", WorldEditorTexts::stays, stays) { copy(stays = it) })
        is GoalCondition.NeverTouch -> listOf(touchFields(this))

        is GoalCondition.DrawTemplate -> listOf(
            tolerance(tolerance) { copy(tolerance = it) },
            Field.Number("field-coverage", WorldEditorTexts::coverage, coverage, percent(1.0)) { copy(coverage = it) },
            Field.Number("field-excess", WorldEditorTexts::excess, excess, percent(WorldLimits.MAXIMUM_EXCESS)) {
                copy(excess = it)
            },
        )

        is GoalCondition.InkLength -> inkFields(this)

        is GoalCondition.FollowLine -> listOf(
            Field.Number("field-laps", WorldEditorTexts::laps, laps, LAPS) { copy(laps = it) },
            tolerance(tolerance) { copy(tolerance = it) },
        )

        is GoalCondition.EndWithin -> listOf(
            Field.Number("field-seconds", WorldEditorTexts::seconds, seconds.toDouble(), SECONDS) {
                copy(seconds = it.toInt())
            },
        )

        is GoalCondition.ShowOnDisplay -> listOf(
            Field.Text("field-text", WorldEditorTexts::text, text, DISPLAY) { copy(text = it) },
            Field.Flag("field-stays", WorldEditorTexts::stays, stays) { copy(stays = it) },
        )

        is GoalCondition.PlaySound -> soundFields(this)

        is GoalCondition.StayOut, is GoalCondition.StayIn,
        is GoalCondition.InOrder, is GoalCondition.All, is GoalCondition.AnyOf,
        -> emptyList()
    }
}

/** The kinds of elements that the robot must not touch; at least one. */
private fun touchFields(condition: GoalCondition.NeverTouch): Field<GoalCondition> = with(condition) {
    val flags = TouchKind.entries.map { kind ->
        Field.Flag("touch-${kind.name.lowercase()}", wordFor(kind), kind in what) { on ->
            copy(what = if (on) what + kind else what - kind)
        }
    }
    Field.Group(listOf(Field.Heading(WorldEditorTexts::touchWhat)) + flags, isAllowed = what.isNotEmpty())
}

private fun tolerance(value: Double, with: (Double) -> GoalCondition) =
    Field.Number("field-tolerance", WorldEditorTexts::tolerance, value, TOLERANCE, with)

private fun inkFields(ink: GoalCondition.InkLength): List<Field<GoalCondition>> = with(ink) {
    val isAllowed = (atLeast != null || atMost != null) && areInOrder(atLeast, atMost)
    val (least, most) = ("field-least" to WorldEditorTexts::length) to ("field-most" to WorldEditorTexts::length)
    val (first, last) = minOf(DEFAULT_INK, atMost ?: DEFAULT_INK) to maxOf(DEFAULT_INK, atLeast ?: DEFAULT_INK)
    listOf(
        optionalNumber("field-has-least" to WorldEditorTexts::atLeast, least, atLeast, first, INK, isAllowed) {
            copy(atLeast = it)
        },
        optionalNumber("field-has-most" to WorldEditorTexts::atMost, most, atMost, last, INK, isAllowed) {
            copy(atMost = it)
        },
    )
}

private fun soundFields(sound: GoalCondition.PlaySound): List<Field<GoalCondition>> = with(sound) {
    val min = lowest?.toDouble()
    val max = highest?.toDouble()
    val isAllowed = areInOrder(min, max)
    val number = "field-times" to WorldEditorTexts::times
    val (low, high) = ("field-lowest" to WorldEditorTexts::pitch) to ("field-highest" to WorldEditorTexts::pitch)
    val (first, last) = minOf(DEFAULT_TONE, max ?: DEFAULT_TONE) to maxOf(DEFAULT_TONE, min ?: DEFAULT_TONE)
    listOf(
        optionalNumber("field-has-times" to WorldEditorTexts::counted, number, times?.toDouble(), 1.0, SOUNDS) {
            copy(times = it?.toInt())
        },
        optionalNumber("field-has-lowest" to WorldEditorTexts::lowest, low, min, first, TONES, isAllowed) {
            copy(lowest = it?.toInt())
        },
        optionalNumber("field-has-highest" to WorldEditorTexts::highest, high, max, last, TONES, isAllowed) {
            copy(highest = it?.toInt())
        },
    )
}

/** Why [goal], without its parts, is invalid; null if it is valid. */
internal fun errorOf(goal: Goal): WorldEditError? {
    val condition = goal.condition
    val names = listOfNotNull((condition as? HasActor)?.who, (condition as? HasLine)?.line)
    val says = goal.says
    val isText = (says == null || isValidText(says, WorldLimits.MAXIMUM_SENTENCE_CHARACTERS)) &&
        names.all { isValidText(it, WorldLimits.MAXIMUM_NAME_CHARACTERS) }
    return if (isText) fieldsOf(condition).error else WorldEditError.InvalidText
}

/** Why the values of fields are invalid; null if they are valid. */
internal val List<Field<*>>.error: WorldEditError?
    get() = ungrouped().find { !it.isValid }
        ?.let { if (it is Field.Text) WorldEditError.InvalidText else WorldEditError.OutOfRange }

/** The goal with its numbers rounded as in a file. */
internal fun Goal.tidied(): Goal {
    val count = fieldsOf(condition).size
    return copy(
        condition = (0..<count).fold(condition) { tidied, place ->
            fieldsOf(tidied)[place].rounded() ?: tidied
        },
    )
}

private fun Field<GoalCondition>.rounded(): GoalCondition? = when (this) {
    is Field.Number -> if (spec.isWhole) null else with(nearestDecimal(value))
    is Field.OptionalNumber -> number?.rounded()
    else -> null
}

private fun areInOrder(lower: Double?, upper: Double?) = lower == null || upper == null || lower <= upper

private fun wordFor(kind: TouchKind): Words = when (kind) {
    TouchKind.WALLS -> WorldEditorTexts::kindWalls
    TouchKind.BARRIERS -> WorldEditorTexts::kindBarriers
    TouchKind.BLOCKS -> WorldEditorTexts::kindBlocks
    TouchKind.ROBOTS -> WorldEditorTexts::kindRobots
}

private fun percent(maximum: Double) =
    NumberSpec(0.0..maximum, isPercent = true, step = 5.0, unit = "%", slider = 0.0..PERCENT)

private const val PERCENT = 100.0
private const val DEFAULT_TONE = 440.0
private val SECONDS = NumberSpec(1..WorldLimits.MAXIMUM_SECONDS, step = 5.0, unit = "s", slider = 1.0..120.0)
private val SOUNDS = NumberSpec(1..WorldLimits.MAXIMUM_SOUNDS)
private val TONES = NumberSpec(WorldLimits.LOWEST_TONE..WorldLimits.HIGHEST_TONE, step = 10.0, unit = "Hz")
private val INK = NumberSpec(0.0..WorldLimits.MAXIMUM_INK, step = 10.0, unit = "cm")
private val LAPS = NumberSpec(WorldLimits.MINIMUM_LAPS..WorldLimits.MAXIMUM_LAPS, slider = 1.0..10.0)
private val TOLERANCES = WorldLimits.MINIMUM_THICKNESS..WorldLimits.MAXIMUM_TOLERANCE
private val TOLERANCE = NumberSpec(TOLERANCES, step = 0.5, unit = "cm", slider = 0.5..10.0)
private val DISPLAY = TextSpec(WorldLimits.MAXIMUM_DISPLAY_CHARACTERS)
