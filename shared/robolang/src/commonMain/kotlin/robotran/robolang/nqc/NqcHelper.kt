package robotran.robolang.nqc

import robotran.robolang.robot.RobotTarget
import robotran.robolang.robot.thirdMotor
import robotran.robolang.run.RobotConstants

/**
 * Something that a translation contains only if it is used.
 *
 * @property called its name.
 * @property text its NQC. `AHEAD` and `BACK` stand for the calls that turn the wheels of the robot so.
 * @property needs what it uses, which is above it.
 */
internal enum class NqcHelper(val called: String, val text: String, val needs: List<NqcHelper> = emptyList()) {
    WHEELS("LEFT", ""),
    PEN("PEN", ""),
    METRE("METRE", ""),
    CIRCLE("CIRCLE", ""),
    CENTIMETRES("CM", "#define CM(x) (((x) * METRE + 50) / 100)", listOf(METRE)),
    DEGREES("DEGREES", "#define DEGREES(x) (((x) * CIRCLE + 180) / 360)", listOf(CIRCLE)),
    SHOWN("shown", "int shown;"),
    FORWARD("forward", move("forward", "AHEAD(LEFT + RIGHT);"), listOf(WHEELS)),
    BACKWARD("backward", move("backward", "BACK(LEFT + RIGHT);"), listOf(WHEELS)),
    LEFT_TURN("turnLeft", move("turnLeft", "BACK(LEFT);\n    AHEAD(RIGHT);"), listOf(WHEELS)),
    RIGHT_TURN("turnRight", move("turnRight", "AHEAD(LEFT);\n    BACK(RIGHT);"), listOf(WHEELS)),
    FORWARD_BY("forwardBy", by("forwardBy", "cm", "METRE", "forward", "backward"), listOf(METRE, FORWARD, BACKWARD)),
    BACKWARD_BY("backwardBy", by("backwardBy", "cm", "METRE", "backward", "forward"), listOf(METRE, FORWARD, BACKWARD)),
    LEFT_BY(
        "turnLeftBy",
        by("turnLeftBy", "degrees", "CIRCLE", "turnLeft", "turnRight"),
        listOf(CIRCLE, LEFT_TURN, RIGHT_TURN),
    ),
    RIGHT_BY(
        "turnRightBy",
        by("turnRightBy", "degrees", "CIRCLE", "turnRight", "turnLeft"),
        listOf(CIRCLE, LEFT_TURN, RIGHT_TURN),
    ),
    PEN_DOWN("penDown", pen("penDown", "OnFwd"), listOf(PEN)),
    PEN_UP("penUp", pen("penUp", "OnRev"), listOf(PEN)),
    PLAY(
        "play",
        """
        // Plays a tone to its end; a time is in hundredths of a second.
        void play(const int &frequency, const int time) {
            PlayTone(frequency, time);
            Wait(time);
        }
        """.trimIndent(),
    ),
    SHOW(
        "show",
        """
        // Shows a number; decimals is how many of its digits are behind the point.
        void show(int number, const int decimals) {
            shown = number;
            SetUserDisplay(shown, decimals);
            SelectDisplay(DISPLAY_USER);
        }
        """.trimIndent(),
        listOf(SHOWN),
    ),
    ;

    /** Its NQC for [robot]. */
    fun textFor(robot: RobotTarget.Rcx): String = when (this) {
        WHEELS -> {
            "// The motors of the wheels.\n#define LEFT OUT_${robot.left}\n#define RIGHT OUT_${robot.right}"
        }

        PEN -> {
            "// The pen's motor.\n#define PEN OUT_${robot.thirdMotor}"
        }

        METRE -> {
            val time = hundredths(robot.millisecondsPerCentimetre * CENTIMETRES_PER_METRE)
            "// Hundredths of a second for 100 cm. Let the robot drive 100 cm and correct it.\n" +
                "#define METRE $time"
        }

        CIRCLE -> {
            val time = hundredths(robot.millisecondsPerDegree * DEGREES_PER_CIRCLE)
            "// Hundredths of a second for a full turn. Let the robot turn ten times round and correct it.\n" +
                "#define CIRCLE $time"
        }

        else -> {
            text.replace("AHEAD(", if (robot.isReversed) "OnRev(" else "OnFwd(")
                .replace("BACK(", if (robot.isReversed) "OnFwd(" else "OnRev(")
        }
    }

    private fun hundredths(milliseconds: Double): Int = (milliseconds / MILLISECONDS_PER_HUNDREDTH + HALF).toInt()

    private companion object {
        const val CENTIMETRES_PER_METRE = 100
        const val DEGREES_PER_CIRCLE = 360
        const val MILLISECONDS_PER_HUNDREDTH = 10
        const val HALF = 0.5
    }
}

private fun move(name: String, motors: String) =
    "void $name(const int &time) {\n    $motors\n    Wait(time);\n    Off(LEFT + RIGHT);\n}"

/** A move of a measure that the program computes; in two parts, so that the products stay within 16 bits. */
private fun by(name: String, measure: String, figure: String, move: String, opposite: String): String {
    val parts = if (figure == "METRE") "10" else "36"
    return "void $name(int $measure) {\n" +
        "    int time = ($measure / 10 * $figure + $measure % 10 * $figure / 10) / $parts;\n" +
        "    if (time < 0) $opposite(0 - time);\n    else $move(time);\n}"
}

private fun pen(name: String, start: String) =
    "void $name() {\n    $start(PEN);\n    Wait(${RobotConstants.PEN_MILLISECONDS / 10});\n    Off(PEN);\n}"
