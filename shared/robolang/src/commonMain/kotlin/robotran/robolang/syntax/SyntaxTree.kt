package robotran.robolang.syntax

import robotran.language.source.SourceRange
import robotran.robolang.words.lowercaseKeyword

/**
 * The syntax tree of a program. Every range in a tree is different, so that a range identifies its node.
 *
 * @property robot the header; null if there is none.
 * @property routines the procedures and functions, in source order.
 * @property behaviours the `whenever` blocks, in source order; later ones have priority.
 * @property statements the main program: everything else.
 * @property comments all comments in order, with `//`. Only the formatter needs them.
 */
internal data class SyntaxTree(
    val robot: RobotHeader?,
    val routines: List<Routine>,
    val behaviours: List<Behaviour>,
    val statements: List<Statement>,
    val comments: List<Token>,
)

/** `robot` .. `end`. */
internal data class RobotHeader(val range: SourceRange, val endRange: SourceRange, val settings: List<RobotSetting>) {
    /** The settings of light sensors; `light` reads the first. */
    val lightSensors: List<LightSensorSetting> get() = settings.filterIsInstance<LightSensorSetting>()
    val lightSensor: LightSensorSetting? get() = lightSensors.firstOrNull()

    /** The setting of the brick; null if the header does not name it. */
    val brick: BrickSetting? get() = settings.filterIsInstance<BrickSetting>().lastOrNull()

    /** The settings of the sensors that only an NXT has; the word of a kind reads the first of its kind. */
    val nxtSensors: List<SensorSetting> get() = settings.filterIsInstance<SensorSetting>()
}

/** A name as typed. */
internal data class Name(val range: SourceRange, val text: String) {
    /** The name in lower case, for comparison: names ignore the case of A to Z. */
    val key: String get() = lowercaseKeyword(text)
}

/**
 * `procedure p(a, b)` .. `end` or `function f(a)` .. `end`.
 *
 * @property range the first line, from its keyword to the closing bracket.
 * @property endRange the `end`; zero-width at the end of the program if missing.
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
