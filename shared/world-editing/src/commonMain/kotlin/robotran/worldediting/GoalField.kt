package robotran.worldediting

import robotran.json.nearestDecimal
import robotran.world.GoalCondition
import robotran.world.TouchKind

/** What a figure of a goal is called; an editor has words for each. */
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

/**
 * A figure of a goal's condition that can be changed by itself, as it is now. A change makes the whole condition anew.
 */
sealed interface GoalField {
    val name: GoalFieldName

    /** Why a world cannot have it as it is; null if it can. */
    val error: EditError? get() = null

    /** The condition with this figure as a file keeps it; null if a file keeps every one. */
    fun rounded(): GoalCondition? = null

    class Flag(override val name: GoalFieldName, val isOn: Boolean, val with: (Boolean) -> GoalCondition) : GoalField

    class Text(
        override val name: GoalFieldName,
        val text: String,
        val maximum: Int,
        val with: (String) -> GoalCondition,
    ) : GoalField {
        override val error: EditError? get() = EditError.NoSuchText.takeIf { !isText(text, maximum) }
    }

    class Number(
        override val name: GoalFieldName,
        val value: Double,
        val spec: NumberSpec,
        val with: (Double) -> GoalCondition,
    ) : GoalField {
        override val error: EditError? get() = EditError.OutOfRange.takeIf { value !in spec.range }

        override fun rounded(): GoalCondition? = if (spec.isWhole) null else with(nearestDecimal(value))
    }

    /**
     * A number that may be left out.
     *
     * @property default what it is at first when it is not left out any more.
     * @param isAllowed whether it goes with the other figures of the goal.
     */
    class OptionalNumber(
        override val name: GoalFieldName,
        val value: Double?,
        val default: Double,
        val spec: NumberSpec,
        private val isAllowed: Boolean = true,
        val with: (Double?) -> GoalCondition,
    ) : GoalField {
        override val error: EditError?
            get() = EditError.OutOfRange.takeIf { !isAllowed || (value != null && value !in spec.range) }

        override fun rounded(): GoalCondition? = if (spec.isWhole) null else value?.let { with(nearestDecimal(it)) }
    }

    /** The name of a mark that is a line. */
    class Line(
        override val name: GoalFieldName,
        val line: String,
        val maximum: Int,
        val with: (String) -> GoalCondition,
    ) : GoalField {
        override val error: EditError? get() = EditError.NoSuchText.takeIf { !isText(line, maximum) }
    }

    /** Kinds of things that are not to be touched; there must be one. */
    class TouchKinds(
        override val name: GoalFieldName,
        val kinds: Set<TouchKind>,
        val with: (Set<TouchKind>) -> GoalCondition,
    ) : GoalField {
        override val error: EditError? get() = EditError.OutOfRange.takeIf { kinds.isEmpty() }
    }
}

/**
 * How a number is counted.
 *
 * @property isPercent whether people are shown a hundred times the number.
 * @property step by how much buttons change what is shown.
 * @property slider what is usual of what is shown; null for no slider.
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
