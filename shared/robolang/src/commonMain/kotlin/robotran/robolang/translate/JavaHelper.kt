package robotran.robolang.translate

import robotran.brick.kind.BrickKind
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.translate.JavaMathTexts as Maths
import robotran.robolang.translate.JavaMoveTexts as Moves
import robotran.robolang.translate.JavaNumberTexts as Numbers
import robotran.robolang.translate.JavaOtherTexts as Others
import robotran.robolang.translate.JavaReactingTexts as Reacting

/**
 * A method or field that a translation contains only if it is used.
 *
 * @property called its name.
 * @property text its Java, indented as a class member, in a program without behaviours; empty for the robot's figures.
 * @property isCalculation whether it is in the class [CALCULATION]: its many constants must not use up those of the
 * program's class, whose constant indices are bytes.
 * @property needs the helpers that it uses, which are declared above it.
 * @property brick the only brick that it is for; null for both.
 */
internal enum class JavaHelper(
    val called: String,
    val text: String,
    val needs: List<JavaHelper> = emptyList(),
    val isField: Boolean = false,
    val isCalculation: Boolean = false,
    private val reactingText: String? = null,
    private val brick: BrickKind? = null,
) {
    CENTIMETRE("MILLISECONDS_PER_CENTIMETRE", "", isField = true),
    DEGREE("MILLISECONDS_PER_DEGREE", "", isField = true),
    PEN_TIME("PEN_MILLISECONDS", "", isField = true),
    PILOT_FIELD("pilot", "", isField = true, brick = BrickKind.NXT),
    DICE("dice", Numbers.DICE, isField = true),
    TIMER_START("timerStart", Others.TIMER_START, isField = true),
    CONTROL("mainIsPaused", Reacting.CONTROL, isField = true),
    GIVE_WAY("giveWay", Reacting.GIVE_WAY, listOf(CONTROL)),
    PAUSE("pause", Reacting.PAUSE, listOf(GIVE_WAY)),
    PAUSE_IN_CONTROL("pauseInControl", Reacting.PAUSE_IN_CONTROL, listOf(GIVE_WAY)),
    ROUND_HALF_UP("roundHalfUp", Numbers.ROUND_HALF_UP),
    WAIT_SECONDS("waitSeconds", Moves.WAIT_SECONDS, listOf(ROUND_HALF_UP)),
    WAIT_MILLISECONDS("waitMilliseconds", Moves.WAIT_MILLISECONDS, listOf(ROUND_HALF_UP)),
    PILOT("Pilot", "", brick = BrickKind.NXT),
    AWAIT_MOTOR("awaitMotor", "", listOf(GIVE_WAY), brick = BrickKind.NXT),
    TURN_MOTOR("turnMotor", "", listOf(AWAIT_MOTOR), brick = BrickKind.NXT),
    SPEED_OF("speedOf", "", brick = BrickKind.NXT),
    SHOW_TEXT("show", "", brick = BrickKind.NXT),
    SHOW_COLOUR("showColour", "", listOf(SHOW_TEXT), brick = BrickKind.NXT),
    DURATION_OF("durationOf", Moves.DURATION_OF, listOf(ROUND_HALF_UP)),
    STOP_AT("stopAt", Moves.STOP_AT, reactingText = Reacting.STOP_AT),
    FORWARD_CENTIMETRES("forwardCentimetres", Moves.FORWARD_CENTIMETRES, listOf(CENTIMETRE, DURATION_OF, STOP_AT)),
    BACKWARD_CENTIMETRES("backwardCentimetres", Moves.BACKWARD_CENTIMETRES, listOf(CENTIMETRE, DURATION_OF, STOP_AT)),
    FORWARD_SECONDS("forwardSeconds", Moves.FORWARD_SECONDS, listOf(DURATION_OF, STOP_AT)),
    BACKWARD_SECONDS("backwardSeconds", Moves.BACKWARD_SECONDS, listOf(DURATION_OF, STOP_AT)),
    LEFT_DEGREES("turnLeftDegrees", Moves.LEFT_DEGREES, listOf(DEGREE, DURATION_OF, STOP_AT)),
    RIGHT_DEGREES("turnRightDegrees", Moves.RIGHT_DEGREES, listOf(DEGREE, DURATION_OF, STOP_AT)),
    LEFT_SECONDS("turnLeftSeconds", Moves.LEFT_SECONDS, listOf(DURATION_OF, STOP_AT)),
    RIGHT_SECONDS("turnRightSeconds", Moves.RIGHT_SECONDS, listOf(DURATION_OF, STOP_AT)),
    PEN_DOWN("penDown", Moves.PEN_DOWN, listOf(PEN_TIME), reactingText = Reacting.PEN_DOWN),
    PEN_UP("penUp", Moves.PEN_UP, listOf(PEN_TIME), reactingText = Reacting.PEN_UP),
    POWER_BOTH("power", Moves.POWER_BOTH),
    PLAY("play", Others.PLAY, listOf(ROUND_HALF_UP)),
    SHOW_WHOLE("show", Others.SHOW_WHOLE),
    SHOW_DECIMAL("show", Others.SHOW_DECIMAL, listOf(ROUND_HALF_UP)),
    TIMER("timer", Others.TIMER, listOf(TIMER_START)),
    RESET_TIMER("resetTimer", Others.RESET_TIMER, listOf(TIMER_START)),
    REMAINDER("remainder", Numbers.REMAINDER),
    RANDOM("random", Numbers.RANDOM, listOf(DICE)),
    RANDOM_DECIMAL("random", Numbers.RANDOM_DECIMAL, listOf(DICE)),
    FLOOR("floor", Numbers.FLOOR),
    CEIL("ceil", Numbers.CEIL),
    ROUND("round", Numbers.ROUND, listOf(FLOOR)),
    SQRT("sqrt", Numbers.SQRT),
    QUARTER_SINE("sineOfSmall", Maths.QUARTER_SINE, listOf(ROUND), isCalculation = true),
    SIN("sin", Maths.SIN, listOf(QUARTER_SINE), isCalculation = true),
    COS("cos", Maths.COS, listOf(QUARTER_SINE), isCalculation = true),
    TAN("tan", Maths.TAN, listOf(SIN, COS), isCalculation = true),
    ATAN2("atan2", Maths.ATAN2, isCalculation = true),
    POW("pow", Maths.POW, listOf(ROUND), isCalculation = true),
    ;

    /** Its Java for [robot], for a program with behaviours if [isReacting]. */
    fun textIn(isReacting: Boolean, robot: BrickKind): String =
        (if (robot == BrickKind.NXT) NxtTexts.of(this, isReacting) else null) ?: textIn(isReacting)

    /** The helpers that its Java for [robot] uses. */
    fun needsOn(robot: BrickKind, isReacting: Boolean): List<JavaHelper> = when {
        robot == BrickKind.RCX -> needs
        this == PILOT_FIELD -> listOf(PILOT)
        this == PILOT -> if (isReacting) listOf(GIVE_WAY) else emptyList()
        else -> NxtTexts.needsOf(this, isReacting) ?: needs
    }

    private fun textIn(isReacting: Boolean): String = when {
        !isReacting || this == GIVE_WAY || this == PAUSE || this == PAUSE_IN_CONTROL -> text
        else -> reactingText ?: text.replace("Thread.sleep(", "pause(")
    }

    companion object {
        /** The class for helpers with many constants. */
        const val CALCULATION = "Calculation"

        /** Names that no variable of a program for [robot] may have. */
        fun fields(robot: BrickKind): Set<String> = namesOf(robot) { it.isField } + OTHER_FIELDS

        /** Names that no routine of a program for [robot] may have. */
        fun methods(robot: BrickKind): Set<String> = namesOf(robot) { !it.isField } + OTHER_METHODS

        private fun namesOf(robot: BrickKind, isMeant: (JavaHelper) -> Boolean): Set<String> =
            entries.filter { isMeant(it) && (it.brick == null || it.brick == robot) }.map { it.called }.toSet()

        private val OTHER_FIELDS =
            setOf("mainThread", "watchingThread", "mainIsPaused", "mainStandsStill", "actionIsSuppressed", "takenOver")

        private val OTHER_METHODS =
            setOf("cosineOfSmall", "arcOf", "smallArcOf", "wholePower", "logarithmToBase2", "powerOfTwo", "mustGiveWay")

        /** The helper for [builtIn]. */
        fun of(builtIn: BuiltIn): JavaHelper = entries.first { it.name == builtIn.name }
    }
}
