package robotran.worldediting

import robotran.json.nearestDecimal
import robotran.world.GoalCondition
import robotran.world.TouchKind

/** The names of goal fields; editors translate them. */
enum class GoalFieldName {
    WHOLE,
    STAYS,
    WITHIN,
    TOUCH_KINDS,
    TOLERANCE,
    COVERAGE,
    EXCESS,
    MIN_LENGTH,
    MAX_LENGTH,
    LINE,
    LAPS,
    SECONDS,
    TEXT,
    TIMES,
    LOWEST_TONE,
    HIGHEST_TONE,
}

/** An editable field of a goal's condition with its value. A change creates a new condition. */
sealed interface GoalField {
    val name: GoalFieldName

    /** Why the value is invalid; null if it is valid. */
    val error: WorldEditError? get() = null

    /** The condition with this value rounded as in a file; null if a file needs no rounding. */
    fun rounded(): GoalCondition? = null

    class Flag(override val name: GoalFieldName, val isOn: Boolean, val with: (Boolean) -> GoalCondition) : GoalField

    class Text(
        override val name: GoalFieldName,
        val text: String,
        val maximum: Int,
        val with: (String) -> GoalCondition,
    ) : GoalField {
        override val error: WorldEditError? get() = WorldEditError.InvalidText.takeIf { !isValidText(text, maximum) }
    }

    class Number(
        override val name: GoalFieldName,
        val value: Double,
        val spec: NumberSpec,
        val with: (Double) -> GoalCondition,
    ) : GoalField {
        override val error: WorldEditError? get() = WorldEditError.OutOfRange.takeIf { value !in spec.range }

        override fun rounded(): GoalCondition? = if (spec.isWhole) null else with(nearestDecimal(value))
    }

    /**
     * An optional number.
     *
     * @property default the initial value when the number is added.
     * @param isAllowed whether the value is consistent with the other fields of the goal.
     */
    class OptionalNumber(
        override val name: GoalFieldName,
        val value: Double?,
        val default: Double,
        val spec: NumberSpec,
        private val isAllowed: Boolean = true,
        val with: (Double?) -> GoalCondition,
    ) : GoalField {
        override val error: WorldEditError?
            get() = WorldEditError.OutOfRange.takeIf { !isAllowed || (value != null && value !in spec.range) }

        override fun rounded(): GoalCondition? = if (spec.isWhole) null else value?.let { with(nearestDecimal(it)) }
    }

    class Line(
        override val name: GoalFieldName,
        val line: String,
        val maximum: Int,
        val with: (String) -> GoalCondition,
    ) : GoalField {
        override val error: WorldEditError? get() = WorldEditError.InvalidText.takeIf { !isValidText(line, maximum) }
    }

    /** The kinds of elements that the robot must not touch; at least one. */
    class TouchKinds(
        override val name: GoalFieldName,
        val kinds: Set<TouchKind>,
        val with: (Set<TouchKind>) -> GoalCondition,
    ) : GoalField {
        override val error: WorldEditError? get() = WorldEditError.OutOfRange.takeIf { kinds.isEmpty() }
    }
}

/**
 * The format of a number.
 *
 * @property isPercent whether to display it multiplied by a hundred.
 * @property step step of the displayed value for buttons.
 * @property slider the usual range of the displayed value; null for no slider.
 */
class NumberSpec(
    val range: ClosedRange<Double>,
    val isWhole: Boolean = false,
    val isPercent: Boolean = false,
    val step: Double = 1.0,
    val unit: String = "",
    val slider: ClosedRange<Double>? = null,
) {
    constructor(range: IntRange, step: Double = 1.0, unit: String = "", slider: ClosedRange<Double>? = null) :
        this(range.first.toDouble()..range.last.toDouble(), isWhole = true, step = step, unit = unit, slider = slider)
}
