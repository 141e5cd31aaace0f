package robotran.worldediting

import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.HasActor
import robotran.world.HasLine
import robotran.world.HasRegion
import robotran.world.HasTimeLimit
import robotran.world.World
import robotran.world.WorldLimits
import robotran.world.geometry.Point
import robotran.world.geometry.Shape

/**
 * The fields of a goal in display order: those of its facets, and between them those of its kind. The robot or block
 * and the region are not included, because they depend on what is on the paper.
 *
 * @param timeLimit the world's time limit in seconds.
 */
fun fieldsOf(condition: GoalCondition, timeLimit: Int = World.DEFAULT_TIME_LIMIT): List<GoalField> = buildList {
    if (condition is HasRegion) add(GoalField.Flag(GoalFieldName.WHOLE, condition.whole, condition::withWhole))
    if (condition is HasLine) {
        add(
            GoalField.Line(
                GoalFieldName.LINE,
                condition.line,
                WorldLimits.MAXIMUM_NAME_CHARACTERS,
                condition::withLine,
            ),
        )
    }
    addAll(ownFieldsOf(condition))
    if (condition is HasTimeLimit) {
        add(
            GoalField.OptionalNumber(
                GoalFieldName.WITHIN,
                condition.within?.toDouble(),
                timeLimit.toDouble(),
                SECONDS,
            ) {
                condition.withTimeLimit(it?.toInt())
            },
        )
    }
}

private fun ownFieldsOf(condition: GoalCondition): List<GoalField> = with(condition) {
    when (this) {
        is GoalCondition.Reach -> listOf(GoalField.Flag(GoalFieldName.STAYS, stays) { copy(stays = it) })
        is GoalCondition.NeverTouch -> listOf(GoalField.TouchKinds(GoalFieldName.TOUCH_KINDS, what) { copy(what = it) })

        is GoalCondition.DrawTemplate -> listOf(
            GoalField.Number(GoalFieldName.TOLERANCE, tolerance, TOLERANCE) { copy(tolerance = it) },
            GoalField.Number(GoalFieldName.COVERAGE, coverage, percent(1.0)) { copy(coverage = it) },
            GoalField.Number(GoalFieldName.EXCESS, excess, percent(WorldLimits.MAXIMUM_EXCESS)) { copy(excess = it) },
        )

        is GoalCondition.InkLength -> inkFieldsOf(this)

        is GoalCondition.FollowLine -> listOf(
            GoalField.Number(GoalFieldName.LAPS, laps, LAPS) { copy(laps = it) },
            GoalField.Number(GoalFieldName.TOLERANCE, tolerance, TOLERANCE) { copy(tolerance = it) },
        )

        is GoalCondition.EndWithin -> listOf(
            GoalField.Number(GoalFieldName.SECONDS, seconds.toDouble(), SECONDS) { copy(seconds = it.toInt()) },
        )

        is GoalCondition.ShowOnDisplay -> listOf(
            GoalField.Text(GoalFieldName.TEXT, text, WorldLimits.MAXIMUM_DISPLAY_CHARACTERS) { copy(text = it) },
            GoalField.Flag(GoalFieldName.STAYS, stays) { copy(stays = it) },
        )

        is GoalCondition.PlaySound -> soundFieldsOf(this)

        is GoalCondition.StayOut, is GoalCondition.StayIn,
        is GoalCondition.InOrder, is GoalCondition.All, is GoalCondition.AnyOf,
        -> emptyList()
    }
}

private fun inkFieldsOf(ink: GoalCondition.InkLength): List<GoalField> = with(ink) {
    val isAllowed = (atLeast != null || atMost != null) && areInOrder(atLeast, atMost)
    listOf(
        GoalField.OptionalNumber(
            GoalFieldName.MIN_LENGTH,
            atLeast,
            minOf(DEFAULT_INK, atMost ?: DEFAULT_INK),
            INK,
            isAllowed,
        ) {
            copy(atLeast = it)
        },
        GoalField.OptionalNumber(
            GoalFieldName.MAX_LENGTH,
            atMost,
            maxOf(DEFAULT_INK, atLeast ?: DEFAULT_INK),
            INK,
            isAllowed,
        ) {
            copy(atMost = it)
        },
    )
}

private fun soundFieldsOf(sound: GoalCondition.PlaySound): List<GoalField> = with(sound) {
    val min = lowest?.toDouble()
    val max = highest?.toDouble()
    val isAllowed = areInOrder(min, max)
    listOf(
        GoalField.OptionalNumber(GoalFieldName.TIMES, times?.toDouble(), 1.0, SOUNDS) { copy(times = it?.toInt()) },
        GoalField.OptionalNumber(
            GoalFieldName.LOWEST_TONE,
            min,
            minOf(DEFAULT_TONE, max ?: DEFAULT_TONE),
            TONES,
            isAllowed,
        ) {
            copy(lowest = it?.toInt())
        },
        GoalField.OptionalNumber(
            GoalFieldName.HIGHEST_TONE,
            max,
            maxOf(DEFAULT_TONE, min ?: DEFAULT_TONE),
            TONES,
            isAllowed,
        ) {
            copy(highest = it?.toInt())
        },
    )
}

/** A template goal of each kind; one that refers to a line still needs the line's name. */
fun newGoals(world: World): List<Goal> {
    val region = Shape.Rectangle(Point(world.paper.width * PLACE, world.paper.height / 2), REGION, REGION)
    val sound = GoalCondition.PlaySound()
    return listOf(
        GoalCondition.Reach(region),
        GoalCondition.StayOut(region),
        GoalCondition.StayIn(region),
        GoalCondition.NeverTouch(),
        GoalCondition.DrawTemplate(),
        GoalCondition.InkLength(DEFAULT_INK, null),
        GoalCondition.FollowLine(line = "-"),
        GoalCondition.EndWithin(world.timeLimit),
        GoalCondition.ShowOnDisplay("42"),
        sound,
        GoalCondition.InOrder(listOf(Goal(sound))),
        GoalCondition.All(listOf(Goal(sound))),
        GoalCondition.AnyOf(listOf(Goal(sound))),
    ).map { Goal(it) }
}

/** Why [goal], without its parts, is invalid; null if it is valid. */
internal fun errorOf(goal: Goal): WorldEditError? {
    val says = goal.says
    val who = (goal.condition as? HasActor)?.who
    return when {
        says != null && !isValidText(says, WorldLimits.MAXIMUM_SENTENCE_CHARACTERS) -> WorldEditError.InvalidText
        who != null && !isValidText(who, WorldLimits.MAXIMUM_NAME_CHARACTERS) -> WorldEditError.InvalidText
        else -> fieldsOf(goal.condition).firstNotNullOfOrNull { it.error }
    }
}

/** The goal with its numbers rounded as in a file. */
internal fun Goal.tidied(): Goal {
    val fields = fieldsOf(condition).indices
    return copy(condition = fields.fold(condition) { tidied, number -> fieldsOf(tidied)[number].rounded() ?: tidied })
}

private fun areInOrder(lower: Double?, upper: Double?) = lower == null || upper == null || lower <= upper

private fun percent(maximum: Double) =
    NumberSpec(0.0..maximum, isPercent = true, step = 5.0, unit = "%", slider = 0.0..PERCENT)

private const val PERCENT = 100.0
private const val PLACE = 0.75
private const val REGION = 20.0
private const val DEFAULT_INK = 40.0
private const val DEFAULT_TONE = 440.0
private val SECONDS = NumberSpec(1..WorldLimits.MAXIMUM_SECONDS, step = 5.0, unit = "s", slider = 1.0..120.0)
private val SOUNDS = NumberSpec(1..WorldLimits.MAXIMUM_SOUNDS)
private val TONES = NumberSpec(WorldLimits.LOWEST_TONE..WorldLimits.HIGHEST_TONE, step = 10.0, unit = "Hz")
private val INK = NumberSpec(0.0..WorldLimits.MAXIMUM_INK, step = 10.0, unit = "cm")
private val LAPS = NumberSpec(WorldLimits.MINIMUM_LAPS..WorldLimits.MAXIMUM_LAPS, slider = 1.0..10.0)
private val TOLERANCE =
    NumberSpec(
        WorldLimits.MINIMUM_THICKNESS..WorldLimits.MAXIMUM_TOLERANCE,
        step = 0.5,
        unit = "cm",
        slider = 0.5..10.0,
    )
