package robotran.robolang.python

import robotran.language.Language
import robotran.robolang.RobolangProgram
import robotran.robolang.documentedPrograms
import robotran.robolang.examplePrograms
import robotran.robolang.lessonPrograms
import robotran.robolang.messages.PythonTranslationMessages
import robotran.robolang.recordedPython
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.allExpressions
import robotran.robolang.testPrograms
import kotlin.math.abs
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue
import robotran.robolang.oraclePrograms as oracle

/**
 * Translations are run by a real MicroPython on fake modules of Pybricks, and their calls are those of the interpreter.
 *
 * MicroPython for Node has whole numbers without limit and decimal numbers of 64 bits: the fake modules refuse numbers beyond
 * 31 bits where they come in, and decimal numbers are compared with a tolerance.
 */
class PythonRunTest {
    @Test
    fun `translations of all programs run without an error and make the calls of the interpreter`() {
        if (!MicroPython.isHere) return println("MicroPython is not on this machine: not run.")
        val written = programs.mapValues { (name, program) -> translationOf(name, program) }
        val complete = written.filterValues { it.isComplete }
        val started = System.nanoTime()
        val logs = MicroPython.run(complete.mapValues { it.value.python })
        val seconds = (System.nanoTime() - started) / 1e9
        val comparison = complete.keys.map { name ->
            compared(name, checkNotNull(logs[name]), written.getValue(name).python)
        }
        val report = report(comparison, written.filterValues { !it.isComplete })
        println(report + "\nMicroPython took %.1f s.".format(seconds))
        System.getenv("ROBOTRAN_REPORT")?.let {
            java.io.File(it).writeText(
                report + comparison.joinToString("\n") +
                    complete.entries.joinToString("\n") { "=== ${it.key}\n${it.value.python}\n${logs[it.key]}" },
            )
        }
        assertEquals(emptyList(), comparison.filter { it.isWrong && it.name !in KNOWN }.map { it.toString() }, report)
        assertEquals(
            emptySet(),
            KNOWN.keys - comparison.filter {
                it.isWrong
            }.map { it.name }.toSet(),
            "no longer differ",
        )
    }

    @Test
    fun `translations for each hub run without an error`() {
        if (!MicroPython.isHere) return
        for (robot in PybricksHub.entries.map { PybricksRobot.usual(it) }) {
            val complete = programs.mapValues {
                translateToPython(it.value, robot, messages)
            }.filterValues { it.isComplete }
            val logs = MicroPython.run(complete.mapValues { it.value.python })
            val failed = logs.filter { (name, log) ->
                log.last().startsWith("# error") && name !in KNOWN &&
                    !runOnHub(programs.getValue(name), robot).end.startsWith("error")
            }
            assertEquals(emptyMap(), failed, "${robot.hub}, of ${complete.size} programs")
        }
    }

    @Test
    fun `translations print what the same programs printed on a hub`() {
        if (!MicroPython.isHere) return
        val programs = recordedPythonSources.filterKeys { printed(it) != null }
        val logs = MicroPython.run(
            programs.mapValues { (name, text) ->
                pythonOf(text, robotFor(text), name = name).python
            },
        )
        for (name in programs.keys) {
            val lines = logs.getValue(name).filter { it.startsWith("print") }
            val wanted = checkNotNull(printed(name)).map { "print \"$it\"" }
            val isAlike =
                lines.size == wanted.size && lines.zip(wanted).all { (first, second) -> areAlike(first, second) }
            assertTrue(isAlike, "$name: $lines, not $wanted")
        }
    }

    /** The lines that a hub printed, without those that are random; null if none are recorded. */
    private fun printed(name: String): List<String>? =
        recordedPython[name.removeSuffix(".robo") + ".out.txt"]?.lines()?.filter { it.isNotEmpty() }

    @Test
    fun `the fake modules do what a hub does`() {
        if (!MicroPython.isHere) return
        val logs = MicroPython.run(oracle.filterKeys { it.endsWith(".py") })
        for ((name, log) in logs) {
            val lines = log.filter { it.startsWith("print") }.map { it.removePrefix("print \"").removeSuffix("\"") }
            val wanted = oracle.getValue(name.removeSuffix(".py") + ".out").lines().filter {
                it.isNotEmpty() &&
                    it != STOPPED
            }
            assertEquals(wanted, lines, name)
        }
    }

    private val programs: Map<String, RobolangProgram> = (
        testPrograms + documentedPrograms + examplePrograms +
            lessonPrograms +
            recordedPythonSources
    )
        .mapNotNull { (name, text) -> programForHub(text, name)?.let { name to it } }.toMap()

    private fun translationOf(name: String, program: RobolangProgram): PythonTranslation =
        translateToPython(program, robotOf(program), messages)

    private fun report(all: List<Comparison>, refused: Map<String, PythonTranslation>): String = buildString {
        appendLine(
            "${programs.size} programs: ${all.size} run, ${refused.size} refused, ${all.sumOf {
                it.calls
            }} calls",
        )
        all.groupingBy { it.result }.eachCount().forEach { (result, count) -> appendLine("  $count $result") }
        refused.values.map { it.notes.first { note -> note.isLost }.message }.groupingBy { it }.eachCount()
            .forEach { (message, count) -> appendLine("  refused $count: $message") }
    }

    private fun compared(name: String, log: List<String>, text: String): Comparison {
        val program = programs.getValue(name)
        val python = HubRun.ofLog(log, text)
        val robolang = runOnHub(program, robotOf(program))
        val reason = reasonNotToCompare(program)
        val same = python.calls.zip(robolang.calls).takeWhile { (first, second) -> areAlike(first, second) }.size
        val isCutOff = !python.isOver || !robolang.isOver
        val size = if (isCutOff) {
            minOf(
                python.calls.size,
                robolang.calls.size,
            )
        } else {
            maxOf(python.calls.size, robolang.calls.size)
        }
        val detail = "call $same: ${python.calls.getOrNull(same)} (${python.end}), not " +
            "${robolang.calls.getOrNull(same)} (${robolang.end})"
        return when {
            python.end.startsWith(
                "error",
            ) && robolang.end.startsWith("error") -> Comparison(name, "fail as in Robolang", same)
            python.end.startsWith("error") -> Comparison(name, "fail", same, python.end, isWrong = true)
            robolang.end.startsWith("error") -> Comparison(name, "fail only in Robolang", same, robolang.end)
            reason != null -> Comparison(name, "not compared: $reason", same, detail)
            same == size -> Comparison(name, "make the same calls", same)
            else -> Comparison(name, "differ", same, detail, isWrong = true)
        }
    }

    private fun reasonNotToCompare(program: RobolangProgram): String? {
        val tree = program.checked.tree
        val expressions = allExpressions(tree)
        return when {
            expressions.any { it is Expression.Call && it.name.key == BuiltIn.RANDOM.text } -> "random numbers"
            expressions.any { it is Expression.Sense && it.sense is Sense.Sensor } -> "ports of an NXT"
            else -> null
        }
    }

    /** Numbers that are shown may differ in their last digits, as decimal numbers of a hub do. */
    private fun areAlike(first: String, second: String): Boolean {
        if (first == second) return true
        val shown = SHOWN.matchEntire(first)?.groupValues?.get(1)?.toDoubleOrNull() ?: return false
        val wanted = SHOWN.matchEntire(second)?.groupValues?.get(1)?.toDoubleOrNull() ?: return false
        return abs(shown - wanted) <= maxOf(ALMOST, abs(wanted) * ALMOST)
    }

    private class Comparison(
        val name: String,
        val result: String,
        val calls: Int,
        private val detail: String = "",
        val isWrong: Boolean = false,
    ) {
        override fun toString(): String = "$name: $result $detail"
    }

    private companion object {
        val messages = PythonTranslationMessages.of(Language.ENGLISH)

        /** What the hub itself prints. */
        const val STOPPED = "The program was stopped (SystemExit)."
        val SHOWN = Regex("print \"(.*)\"")
        const val ALMOST = 1e-4

        /** What differs and is meant to, or cannot be seen here. */
        val KNOWN = mapOf(
            "behaviours/an-action-that-ends-its-own-condition.robo" to "nothing looks at conditions between two waits",
            "behaviours/interrupts-between-statements.robo" to "nothing looks at conditions between two waits",
            "expressions/decimal-division-by-zero.robo" to "a hub does not divide by 0",
            "expressions/decimals-are-32-bit.robo" to "decimal numbers of 64 bits",
            "expressions/tangent.robo" to "decimal numbers of 64 bits",
            "tree.robo" to "decimal numbers of 64 bits",
            "sound/tone-of-no-length.robo" to "a tone of no length is a call on a hub",
            "lessons/sense/08-ring/solution.robo" to "a hub looks every 10 milliseconds",
        )

        /** The robot that has what a program asks for. */
        fun robotOf(program: RobolangProgram): PybricksRobot =
            if (allExpressions(program.checked.tree).any { it is Expression.Sense && it.sense == Sense.Distance }) {
                sonarRobot
            } else {
                bumperRobot
            }
    }
}
