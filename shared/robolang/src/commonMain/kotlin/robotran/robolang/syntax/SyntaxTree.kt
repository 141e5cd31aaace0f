package robotran.robolang.syntax

import robotran.robolang.diagnostic.SourceRange

/**
 * A program as the parser understood it. Every range in a tree is different, so that a node is known by its range.
 *
 * @property robot what is said about the robot, null if nothing is.
 * @property routines the procedures and functions in the order of the source.
 * @property behaviours the `whenever` blocks in the order of the source, the later ones having priority.
 * @property statements the main program: what stands outside all of these.
 * @property comments all comments in their order, `//` included; no statement needs them, a formatter does.
 */
internal data class SyntaxTree(
    val robot: RobotHeader?,
    val routines: List<Routine>,
    val behaviours: List<Behaviour>,
    val statements: List<Statement>,
    val comments: List<Token>,
)

/** `robot` .. `end`. */
internal data class RobotHeader(
    val range: SourceRange,
    val endRange: SourceRange,
    val lightSensor: LightSensorSetting?,
)

/**
 * `light sensor on 2 facing down`.
 *
 * @property port 1..3, as it is printed on the brick.
 */
internal data class LightSensorSetting(val range: SourceRange, val port: Int, val facing: Facing)

/** A name that the pupil gives or uses, as it is typed. */
internal data class Name(val range: SourceRange, val text: String) {
    /** The same for all spellings of one name: names ignore case, letters beyond A to Z excepted. */
    val key: String get() = lowercaseKeyword(text)
}

/**
 * `procedure p(a, b)` .. `end` or `function f(a)` .. `end`.
 *
 * @property range the first line, from its keyword to the closing bracket.
 * @property endRange the `end`; of no width at the end of the program if there is none.
 */
internal data class Routine(
    val range: SourceRange,
    val endRange: SourceRange,
    val name: Name,
    val parameters: List<Name>,
    val body: List<Statement>,
    val isFunction: Boolean,
)

/** `whenever C` .. `end`. */
internal data class Behaviour(
    val range: SourceRange,
    val endRange: SourceRange,
    val condition: Expression,
    val body: List<Statement>,
)

internal enum class Facing { DOWN, FORWARD }
