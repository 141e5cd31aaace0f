package robotran.robolang.words

import robotran.brick.kind.BrickKind

/**
 * What a line of Robolang says. The forms of one keyword differ in the values that they take. Parser, outline, blocks
 * and completion have what they know about a kind of line from its entry.
 *
 * @property marked such a line with values that make sense, those of the tutorial, and what belongs into its block;
 * null if it has names of the pupil's. Two `|` enclose what a pupil writes first.
 * @property choices the words for which others may stand without changing the form; each group is one choice.
 * @property needs what a brick must have for it; null if every one does.
 * @property isOpener whether it begins a block that an `end` closes.
 * @property isOutermost whether it may stand only outside all blocks.
 * @property isSetting whether it may stand only in the header.
 * @property showsAlone whether a pupil sees or hears what it does if it runs alone.
 */
enum class LineForm(
    val marked: String?,
    val group: BlockGroup,
    internal val choices: List<List<String>> = emptyList(),
    internal val needs: BrickFeature? = null,
    val isOpener: Boolean = false,
    val isOutermost: Boolean = false,
    val isSetting: Boolean = false,
    val showsAlone: Boolean = false,
    private val otherExample: (BrickKind) -> String? = { null },
) {
    MOVE("forward |20|", BlockGroup.DRIVE, listOf(DIRECTIONS.texts), showsAlone = true),
    MOVE_FOR_TIME("forward for |2| seconds", BlockGroup.DRIVE, listOf(DIRECTIONS.texts), showsAlone = true),
    TURN("turn left |90|", BlockGroup.DRIVE, listOf(SIDES.texts), showsAlone = true),
    TURN_FOR_TIME("turn left for |1| second", BlockGroup.DRIVE, listOf(SIDES.texts), showsAlone = true),
    START_MOVING("start forward", BlockGroup.DRIVE, listOf(DIRECTIONS.texts), showsAlone = true),
    START_TURNING("start turning left", BlockGroup.DRIVE, listOf(SIDES.texts), showsAlone = true),
    STOP("stop", BlockGroup.DRIVE, showsAlone = true),

    /** The power of both wheels. */
    POWER("power |5|", BlockGroup.DRIVE),
    POWER_OF_SIDE("power left |5|", BlockGroup.DRIVE, listOf(SIDES.texts)),
    MOTOR("motor |A| forward", BlockGroup.DRIVE, listOf(MOTORS, MOTOR_COMMANDS.texts), showsAlone = true),
    POWER_OF_MOTOR("motor |A| power 5", BlockGroup.DRIVE, listOf(MOTORS)),
    MOTOR_TURN("motor |A| turn 90", BlockGroup.DRIVE, listOf(MOTORS), BrickFeature.MOTOR_COUNTERS, showsAlone = true),
    START_MOTOR_TURN(
        "start motor |A| turn 90",
        BlockGroup.DRIVE,
        listOf(MOTORS),
        BrickFeature.MOTOR_COUNTERS,
        showsAlone = true,
    ),
    PEN("pen down", BlockGroup.PEN, listOf(PEN_POSITIONS.texts), showsAlone = true),
    WAIT("wait |1| second", BlockGroup.CONTROL, listOf(TIME_UNITS.texts)),
    WAIT_UNTIL("wait until left bumper", BlockGroup.CONTROL),
    RESET_TIMER("reset timer", BlockGroup.SENSE),
    RESET_MOTOR("reset motor |A|", BlockGroup.SENSE, listOf(MOTORS), BrickFeature.MOTOR_COUNTERS),
    BEEP("beep", BlockGroup.SHOW_AND_SOUND, showsAlone = true),
    BUZZ("buzz", BlockGroup.SHOW_AND_SOUND, showsAlone = true),
    PLAY("play |440| for 1 second", BlockGroup.SHOW_AND_SOUND, showsAlone = true),
    SHOW("show 5", BlockGroup.SHOW_AND_SOUND, showsAlone = true),
    SHOW_TEXT("show \"HELLO\"", BlockGroup.SHOW_AND_SOUND, showsAlone = true),
    CLEAR_SCREEN("clear screen", BlockGroup.SHOW_AND_SOUND, showsAlone = true),
    REPEAT(block("repeat |4| times"), BlockGroup.CONTROL, isOpener = true),
    REPEAT_FOREVER(block("repeat forever"), BlockGroup.CONTROL, isOpener = true),
    REPEAT_WHILE(block("repeat while light > 40"), BlockGroup.CONTROL, isOpener = true),
    REPEAT_UNTIL(block("repeat until light < 40"), BlockGroup.CONTROL, isOpener = true),
    FOR(block("for |i| from 1 to 10"), BlockGroup.CONTROL, isOpener = true),
    FOR_WITH_STEP(block("for |i| from 0 to 10 step 2"), BlockGroup.CONTROL, isOpener = true),
    FOR_EACH(block("for each x in [1, 2, 3]"), BlockGroup.LISTS, isOpener = true),
    BREAK("break", BlockGroup.CONTROL),
    CONTINUE("continue", BlockGroup.CONTROL),
    IF(block("if left bumper"), BlockGroup.CONTROL, isOpener = true),
    ELSE_IF(block("if left bumper", "else if right bumper"), BlockGroup.CONTROL),
    ELSE(block("if left bumper", "else"), BlockGroup.CONTROL),
    HALT("halt", BlockGroup.CONTROL),
    DECLARE_VARIABLE("var x = 5", BlockGroup.NUMBERS),
    DECLARE_CONSTANT("const side = 20", BlockGroup.NUMBERS),
    ASSIGN(null, BlockGroup.NUMBERS),

    /** `list[0] = 5`. */
    ASSIGN_ELEMENT(null, BlockGroup.LISTS),
    PROCEDURE(block("procedure trick()"), BlockGroup.OWN_COMMANDS, isOpener = true, isOutermost = true),
    FUNCTION(
        block("function double(x)", "  return 2 * x"),
        BlockGroup.OWN_COMMANDS,
        isOpener = true,
        isOutermost = true,
    ),
    CALL(null, BlockGroup.OWN_COMMANDS, showsAlone = true),
    RETURN("return", BlockGroup.OWN_COMMANDS),
    RETURN_VALUE("return 5", BlockGroup.OWN_COMMANDS),
    WHENEVER(block("whenever left bumper"), BlockGroup.CONTROL, isOpener = true, isOutermost = true),
    ROBOT(
        block("robot", "  light sensor on 2 facing down"),
        BlockGroup.SENSE,
        isOpener = true,
        isOutermost = true,
        otherExample = { if (it == BrickKind.default) null else block("robot", "  ${brickSetting(it)}") },
    ),
    LIGHT_SENSOR(
        "light sensor on 2 facing down",
        BlockGroup.SENSE,
        PORTS.values + listOf(FACINGS.texts),
        isSetting = true,
        otherExample = { "light sensor on ${BrickDialect.of(it).lightPort} facing down" },
    ),
    SONAR("sonar on 4", BlockGroup.SENSE, sensorPorts(BrickFeature.SONAR), BrickFeature.SONAR, isSetting = true),
    COLOUR_SENSOR(
        "colour sensor on 3",
        BlockGroup.SENSE,
        sensorPorts(BrickFeature.COLOUR_SENSOR),
        BrickFeature.COLOUR_SENSOR,
        isSetting = true,
    ),
    SOUND_SENSOR(
        "sound sensor on 2",
        BlockGroup.SENSE,
        sensorPorts(BrickFeature.SOUND_SENSOR),
        BrickFeature.SOUND_SENSOR,
        isSetting = true,
    ),
    BRICK(
        "brick rcx",
        BlockGroup.SENSE,
        listOf(KINDS.keys.texts),
        isSetting = true,
        otherExample = ::brickSetting,
    ),
    END(null, BlockGroup.CONTROL),
    ;

    /** [marked] without its marks. */
    val example: String? = marked?.replace("|", "")

    /** The example for a robot with [brick]; null if it can do nothing like that. */
    fun exampleOn(brick: BrickKind): String? =
        if (needs == null || needs.isOn(brick)) otherExample(brick) ?: example else null
}

private fun block(vararg lines: String): String = lines.joinToString("\n", postfix = "\nend")

private fun brickSetting(brick: BrickKind): String = "brick ${BrickDialect.of(brick).keyword.text}"

/** The ports of the bricks that have the sensor. */
private fun sensorPorts(sensor: BrickFeature): List<List<String>> = PORTS.filterKeys(sensor.isOn).values.toList()
