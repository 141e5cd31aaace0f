package robotran.robolang.fuzz

import robotran.brick.kind.BrickKind
import robotran.robolang.words.BlockGroup
import robotran.robolang.words.LineForm
import kotlin.random.Random

/** Generates a random valid program, with statements of all kinds and with irregular spaces, capitals and comments. */
class ProgramWriter(private val random: Random, private val isForNxt: Boolean = false) {
    private val text = StringBuilder()
    private val brick = if (isForNxt) BrickKind.NXT else BrickKind.RCX
    private val known = KnownNames()
    private val hasBumpers = !isForNxt || random.nextBoolean()
    private val expressions = ExpressionWriter(random, known, isForNxt, hasBumpers)
    private var names = 0
    private var loops = 0
    private var isProcedure = false

    fun write(): String {
        if (isForNxt) {
            block("robot") {
                line("brick nxt")
                line("sonar on 4")
                line("light sensor on ${if (hasBumpers) 3 else 1} facing ${pick("down", "forward")}")
                if (!hasBumpers) line(pick("colour", "Color") + " sensor on 3")
                if (!hasBumpers) line("sound sensor on 2")
            }
        } else if (random.nextInt(3) == 0) {
            block("robot") { line("light sensor on ${random.nextInt(1, 4)} facing ${pick("down", "forward")}") }
        }
        repeat(random.nextInt(6)) { declare() }
        repeat(random.nextInt(3)) { function() }
        repeat(random.nextInt(3)) { procedure() }
        repeat(random.nextInt(2)) { known.inBlock { block("whenever ${expressions.truth()}") { statements(1) } } }
        statements(0)
        return text.toString()
    }

    private fun function() {
        val name = newName("f")
        known.inBlock {
            val parameter = newName("n").also { known.wholes += it }
            block("function $name($parameter)") {
                statements(2)
                line("return ${expressions.whole()}")
            }
        }
        known.functions += name
    }

    private fun procedure() {
        val name = newName("p")
        known.inBlock {
            val number = newName("n").also { known.wholes += it }
            val truth = newName("t").also { known.truths += it }
            isProcedure = true
            block("procedure $name($number, $truth)") {
                statements(1)
                if (random.nextBoolean()) block("if $number > 3") { line("$name($number / 2, not $truth)") }
            }
            isProcedure = false
        }
        known.procedures += name
    }

    private fun statements(depth: Int) = repeat(random.nextInt(6)) { statement(depth) }

    private fun statement(depth: Int) {
        when (random.nextInt(if (depth < DEEPEST) 34 else 26)) {
            in 0..15 -> line(command())
            in 16..19 -> declare()
            20, 21 -> change()

            22 -> known.oneOf(known.procedures, random)?.let {
                line("$it(${expressions.whole(1)}, ${expressions.truth(1)})")
            }

            23 -> if (loops > 0) line(pick("break", "CONTINUE"))
            24 -> if (isProcedure) line("return")
            25 -> if (random.nextInt(10) == 0) line("halt")
            in 26..29 -> choice(depth + 1)
            else -> loop(depth + 1)
        }
    }

    private fun command(): String =
        if (random.nextInt(10) == 0) EXAMPLES.getValue(brick).random(random) else writtenCommand()

    private fun writtenCommand(): String = when (random.nextInt(if (isForNxt) 25 else 21)) {
        0 -> "forward ${expressions.number()}" + pick("", " cm")
        1 -> "Backward ${expressions.number()}"

        2 -> {
            "${pick("forward", "backward", "turn left", "turn right")} for ${expressions.positive()} " +
                "${pick("seconds", "second")}"
        }

        3 -> "turn left ${expressions.number()}" + pick("", " degrees", " degree")
        4 -> "TURN RIGHT ${expressions.number()}"
        5 -> "start ${pick("forward", "backward", "turning left", "turning right")}"
        6 -> "stop"
        7 -> "power ${pick("", "left ", "right ")}${power()}"
        8 -> "motor ${pick("A", "b", "C")} ${pick("forward", "backward", "stop", "float")}"
        9 -> "motor ${pick("A", "b", "C")} power ${power()}"
        10 -> "pen ${pick("down", "up")}"
        11, 12 -> "wait ${expressions.positive()} ${pick("seconds", "milliseconds", "millisecond")}"
        13 -> "wait until ${expressions.truth()}"
        14 -> "reset timer"
        15 -> "beep"
        16 -> "buzz"
        17 -> "play ${expressions.number()} for ${expressions.positive()} seconds"
        18 -> "show ${expressions.number()}"
        19 -> "show ${pick("\"\"", "\"Hi-_5\"", "\"a\"")}"
        20 -> "clear screen"
        21 -> "${pick("", "start ")}motor ${pick("A", "b", "C")} turn ${expressions.number()}${pick("", " degrees")}"
        22 -> "reset motor ${pick("a", "B", "C")}"
        else -> "show ${if (hasBumpers) "distance" else expressions.colour()}"
    }

    private fun power(): String = pick("0", "7", "abs(${expressions.whole(1)}) mod 8")

    private fun declare() {
        val isConstant = random.nextInt(4) == 0
        val (kind, value) = when (random.nextInt(4)) {
            0 -> known.wholes to expressions.whole()
            1 -> known.decimals to expressions.decimal()
            2 -> known.truths to expressions.truth()
            else -> known.lists to expressions.list()
        }
        val name = newName("v")
        line("${if (isConstant) "const" else "var"} $name = $value")
        kind += name
        if (!isConstant) known.changing += name
    }

    private fun change() {
        val list = known.oneOf(known.lists, random)
        when (random.nextInt(5)) {
            0 -> known.wholes.changing()?.let { line("$it = ${expressions.whole()}") }
            1 -> known.decimals.changing()?.let { line("$it = ${expressions.number()}") }
            2 -> known.truths.changing()?.let { line("$it = ${expressions.truth()}") }
            3 -> known.lists.changing()?.let { line("$it = ${expressions.list()}") }

            else -> if (list != null) {
                line("$list[${pick("0", "2", "abs(${expressions.whole(1)}) mod 3")}] = ${expressions.whole()}")
            }
        }
    }

    private fun List<String>.changing(): String? = filter { it in known.changing }.randomOrNull(random)

    private fun choice(depth: Int) {
        line("if ${expressions.truth()}")
        known.inBlock { statements(depth) }
        repeat(random.nextInt(2)) {
            line("else if ${expressions.truth()}")
            known.inBlock { statements(depth) }
        }
        if (random.nextBoolean()) {
            line("Else")
            known.inBlock { statements(depth) }
        }
        line("end")
    }

    private fun loop(depth: Int) {
        loops++
        known.inBlock {
            val variable = newName("i")
            val kind = random.nextInt(8)
            val opener = when (kind) {
                0 -> "repeat ${pick("0", "3", "abs(${expressions.whole(1)}) mod 5")} ${pick("times", "time")}"
                1 -> "repeat forever"
                2 -> "repeat while ${expressions.truth()}"
                3 -> "repeat until ${expressions.truth()}"
                4 -> "for $variable from ${expressions.whole(1)} to ${expressions.whole(1)}"

                5 -> {
                    "for $variable from ${expressions.whole(1)} to ${expressions.whole(1)} step " +
                        "${pick("2", "-1", "(light + 1)", "200", "-129")}"
                }

                6 -> "for $variable from ${expressions.number(1)} to ${expressions.decimal(1)}"
                else -> "for each $variable in ${expressions.list()}"
            }
            when (kind) {
                in 0..3 -> Unit
                6 -> known.decimals += variable
                else -> known.wholes += variable
            }
            block(opener) { statements(depth) }
        }
        loops--
    }

    private fun block(opener: String, body: () -> Unit) {
        line(opener)
        body()
        line("END")
    }

    private fun line(code: String) {
        val spaced = if (random.nextInt(4) == 0) code.replace(" ", pick("  ", "\t", " ")).replace(",", " ,") else code
        text.append(
            pick("", "  ", "\t"),
        ).append(spaced).append(pick("", "", " // why", "\t//")).append(pick("\n", "\r\n", "\n\n"))
    }

    private fun newName(prefix: String): String = prefix + pick("", "_", "É") + names++

    private fun pick(vararg choices: String): String = expressions.pick(*choices)

    private companion object {
        const val DEEPEST = 3
        val OF_COMMANDS = setOf(BlockGroup.DRIVE, BlockGroup.PEN, BlockGroup.SENSE, BlockGroup.SHOW_AND_SOUND)

        /** An example of each command, so that random programs also have those that are not written above. */
        val EXAMPLES: Map<BrickKind, List<String>> = BrickKind.entries.associateWith { brick ->
            LineForm.entries.filter { it.group in OF_COMMANDS && !it.isOpener && !it.isSetting }
                .mapNotNull { it.exampleOn(brick) }
        }
    }
}
