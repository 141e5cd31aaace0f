package robotran.workshop.examples

import robotran.brick.kind.BrickKind
import robotran.brick.kind.JavaPlatform
import robotran.language.ProgramLanguage
import robotran.world.ReadyRobots

/** The built-in example programs in this language for the [BrickKind.default], text by name. */
val ProgramLanguage.examples: Map<String, String> get() = examplesFor(BrickKind.default)

/**
 * The built-in example programs in this language for a [brick], text by name. Those in Robolang are for every one; what
 * an NXT cannot do in one of them is a mistake there, which names the RCX.
 */
fun ProgramLanguage.examplesFor(brick: BrickKind): Map<String, String> = EXAMPLES[this]?.invoke(brick).orEmpty()

private val EXAMPLES: Map<ProgramLanguage, (BrickKind) -> Map<String, String>> = mapOf(
    ProgramLanguage.ROBOLANG to { brick ->
        when (brick) {
            BrickKind.RCX -> exampleTexts
            BrickKind.NXT -> exampleTexts.mapValues { forNxtPenbot(it.value) }

            BrickKind.SPIKE_PRIME, BrickKind.SPIKE_ESSENTIAL, BrickKind.TECHNIC_HUB, BrickKind.EV3,
            BrickKind.NXT_PYBRICKS, BrickKind.MICROBIT, BrickKind.MICROBIT_V1,
            -> exampleTexts.mapValues { forHub(it.value, brick) }
        }
    },
    ProgramLanguage.JAVA to { brick ->
        when (brick.java) {
            JavaPlatform.LEJOS -> lejosExampleTexts
            JavaPlatform.NXJ -> nxjExampleTexts
            null -> emptyMap()
        }
    },
    ProgramLanguage.NQC to { brick -> if (brick.hasLegoFirmware) nqcExampleTexts else emptyMap() },
)

/**
 * A program in Robolang with the ports and buttons of the NXT penbot. Its light sensor cannot be turned ahead, so what
 * needs that is for an RCX.
 */
private fun forNxtPenbot(text: String): String {
    if ("facing forward" in text) return text.replaceFirst("\nrobot\n", "\nrobot\n  brick rcx\n")
    return NXT_WORDS.fold(text) { changed, (rcx, nxt) -> changed.replace(rcx, nxt) }
}

/**
 * The same for a robot with a hub, whose sensors are found without naming their ports, and whose wheels have other
 * motors.
 */
private fun forHub(text: String, brick: BrickKind): String {
    if ("facing forward" in text) return forNxtPenbot(text)
    val drive = ReadyRobots.defaultOf(brick).drive
    val wheels = mapOf("A" to drive.left.name, "C" to drive.right.name)
    val withoutHeader = text.replace("robot\n  light sensor on 2 facing down\nend\n\n", "")
    return forNxtPenbot(MOTOR.replace(withoutHeader) { "motor ${wheels.getValue(it.groupValues[1])}" })
}

private val MOTOR = Regex("\\bmotor ([AC])\\b")

private val NXT_WORDS = listOf(
    "light sensor on 2" to "light sensor on 3",
    "button view" to "button right",
    "button prgm" to "button left",
    "View" to "RIGHT",
    "Prgm" to "LEFT",
)
