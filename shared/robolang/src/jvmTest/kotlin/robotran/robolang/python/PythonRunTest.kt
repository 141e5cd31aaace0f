package robotran.robolang.python

import robotran.language.Language
import robotran.robolang.RobolangProgram
import robotran.robolang.documentedPrograms
import robotran.robolang.examplePrograms
import robotran.robolang.lessonPrograms
import robotran.robolang.messages.PythonTranslationMessages
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.allExpressions
import robotran.robolang.testPrograms
import kotlin.math.abs
import kotlin.test.Test
import kotlin.test.assertEquals

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
        val comparison = complete.keys.map { name -> compared(name, checkNotNull(logs[name])) }
        val report = report(comparison, written.filterValues { !it.isComplete })
        println(report + "\nMicroPython took %.1f s.".format(seconds))
        java.io.File("/tmp/wP-report.txt").writeText(report + comparison.joinToString("\n") + complete.entries.joinToString("\n") { "=== ${it.key}\n${it.value.python}\n${logs[it.key]}" })
        assertEquals(emptyList(), comparison.filter { it.isWrong }.map { it.toString() }, report)
    }

    private val programs: Map<String, RobolangProgram> = (testPrograms + documentedPrograms + examplePrograms + lessonPrograms)
        .mapNotNull { (name, text) -> programForHub(text, name)?.let { name to it } }.toMap()

    private fun translationOf(name: String, program: RobolangProgram): PythonTranslation =
        translateToPython(program, robotOf(program), messages)

    private fun report(all: List<Comparison>, refused: Map<String, PythonTranslation>): String = buildString {
        appendLine("${programs.size} programs: ${all.size} run, ${refused.size} refused, ${all.sumOf { it.calls }} calls")
        all.groupingBy { it.result }.eachCount().forEach { (result, count) -> appendLine("  $count $result") }
        refused.values.map { it.notes.first { note -> note.isLost }.message }.groupingBy { it }.eachCount()
            .forEach { (message, count) -> appendLine("  refused $count: $message") }
    }

    private fun compared(name: String, log: List<String>): Comparison {
        val program = programs.getValue(name)
        val python = HubRun.ofLog(log)
        val robolang = runOnHub(program, robotOf(program))
        val reason = reasonNotToCompare(program)
        val same = python.calls.zip(robolang.calls).takeWhile { (first, second) -> areAlike(first, second) }.size
        val isCutOff = !python.isOver || !robolang.isOver
        val size = if (isCutOff) minOf(python.calls.size, robolang.calls.size) else maxOf(python.calls.size, robolang.calls.size)
        val detail = "call $same: ${python.calls.getOrNull(same)} (${python.end}), not " +
            "${robolang.calls.getOrNull(same)} (${robolang.end})"
        return when {
            python.end.startsWith("error") && robolang.end.startsWith("error") -> Comparison(name, "fail as in Robolang", same)
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
            PybricksSpeeds(tree, bumperRobot).areApart -> "powers of single wheels"
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
        private val name: String,
        val result: String,
        val calls: Int,
        private val detail: String = "",
        val isWrong: Boolean = false,
    ) {
        override fun toString(): String = "$name: $result $detail"
    }

    private companion object {
        val messages = PythonTranslationMessages.of(Language.ENGLISH)
        val SHOWN = Regex("print \"(.*)\"")
        const val ALMOST = 1e-4

        /** The robot that has what a program asks for. */
        fun robotOf(program: RobolangProgram): PybricksRobot =
            if (allExpressions(program.checked.tree).any { it is Expression.Sense && it.sense == Sense.Distance }) {
                sonarRobot
            } else {
                bumperRobot
            }
    }
}
