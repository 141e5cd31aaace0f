package robotran.robolang

import io.kotest.property.Arb
import io.kotest.property.arbitrary.Codepoint
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.arbitrary.element
import kotlin.random.Random

/** Everything that means something to Robolang, and a little that does not. */
internal val PIECES: List<String> = listOf(
    "forward", "backward", "turn", "pen", "repeat", "wait", "beep", "show", "end", "left", "right", "down", "up", "times", "cm",
    "degrees", "seconds", "milliseconds", "if", "else", "for", "each", "in", "from", "to", "step", "while", "until", "forever", "break",
    "continue", "var", "const", "procedure", "function", "return", "whenever", "halt", "robot", "light", "sensor", "on", "facing", "start",
    "turning", "stop", "power", "motor", "A", "play", "buzz", "clear", "screen", "reset", "timer", "battery", "button", "run", "bumper",
    "true", "false", "and", "or", "not", "mod", "x", "x", "p", "p()", "(", ")", "[", "]", "=", "==", "!=", "<", "<=", ">", ">=", "+", "*",
    "/", "\"HI\"", "\"", "random", "length", "foward", " ", " ", " ", " ", "\n", "\n", "\n", "\r\n", "\r", "\t", "//", "-", ",", ".",
    "0", "4", "2.5", "99999999999", "\uFEFF", "\uD83E\uDD16", "\uD83E", "\u0000", ";", "°", "é",
)

internal val DIGITS: Arb<Codepoint> = Arb.element(('0'..'9').map { Codepoint(it.code) })

private const val DEEPEST = 4

/** A program without mistakes that is short to run. */
internal fun validProgram(): Arb<String> = arbitrary { source ->
    buildString { block(source.random, depth = 0) }
}

private fun StringBuilder.block(random: Random, depth: Int) {
    repeat(random.nextInt(5)) {
        append("  ".repeat(random.nextInt(3)))
        if (depth < DEEPEST && random.nextInt(8) == 0) {
            choice(random, depth)
        } else if (depth < DEEPEST && random.nextInt(4) == 0) {
            append("repeat ${random.nextInt(4)} times\n")
            block(random, depth + 1)
            append("end\n")
        } else {
            append(statement(random)).append(listOf("", " // why", "\t")[random.nextInt(3)]).append('\n')
        }
    }
}

private fun StringBuilder.choice(random: Random, depth: Int) {
    append("if ${condition(random)}\n")
    block(random, depth + 1)
    if (random.nextBoolean()) {
        append("else if ${condition(random)}\n")
        block(random, depth + 1)
    }
    append("Else // otherwise\n")
    block(random, depth + 1)
    append("end\n")
}

private fun condition(random: Random): String = when (random.nextInt(4)) {
    0 -> "left bumper or not(timer<5)"
    1 -> "light -  ${random.nextInt(100)} <= - 20"
    2 -> "[1,2,3] [ ${random.nextInt(3)} ] == 2 and true"
    else -> "${number(random)} * 2 != (${number(random)} + 1)"
}

private fun statement(random: Random): String = when (random.nextInt(7)) {
    0 -> "forward ${number(random)}"
    1 -> "Backward ${number(random)} cm"
    2 -> "turn left ${number(random)} degrees"
    3 -> "TURN RIGHT ${number(random)}"
    4 -> listOf("pen down", "pen up", "beep")[random.nextInt(3)]
    5 -> "wait ${random.nextInt(100)}.${random.nextInt(100)} seconds"
    else -> "show ${number(random)}"
}

private fun number(random: Random): String =
    listOf("", "-", "- ")[random.nextInt(3)] + random.nextInt(1000) + listOf("", ".5", ".125")[random.nextInt(3)]
