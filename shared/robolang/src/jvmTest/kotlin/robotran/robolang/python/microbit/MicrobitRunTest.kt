package robotran.robolang.python.microbit

import robotran.language.Language
import robotran.robolang.documentedBoardPrograms
import robotran.robolang.documentedPrograms
import robotran.robolang.examplePrograms
import robotran.robolang.lessonPrograms
import robotran.robolang.messages.PythonTranslationMessages
import robotran.robolang.python.MicroPython
import robotran.robolang.python.PythonTranslation
import robotran.robolang.python.translateToPython
import robotran.robolang.testPrograms
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/**
 * Translations for a micro:bit are run by a real MicroPython on fake modules of a board, and their calls are those of the
 * interpreter, at the same times.
 */
class MicrobitRunTest {
    @Test
    fun `translations of all programs make the calls of the interpreter at the same times`() {
        if (!MicroPython.isHere) return println("MicroPython is not on this machine: not run.")
        val programs = sources.mapNotNull { (name, text) -> programForBoard(text, name)?.let { name to it } }.toMap()
        val translations = programs.mapValues { (_, program) -> translateToPython(program, program.robot, messages) }
        val (complete, refused) = translations.toList().partition { it.second.isComplete }
        val pins = fakePinsOf(cutebot.buggy)
        val logs = MicroPython.run(
            complete.associate { (name, it) ->
                name to "$pins\n${it.python}"
            },
            MicroPython.BOARD,
        )
        val all = complete.map { (name, it) ->
            compareOnBoard(name, programs.getValue(name), it.python, logs.getValue(name))
        }
        val wrong = all.filter { it.isWrong }
        val report = report(programs.size, all, refused.map { it.second })
        println(report)
        val unknown = wrong.filter { it.name !in KNOWN }.map { "$it\n${logs.getValue(it.name).last()}" }
        assertEquals(emptyList(), unknown, report)
        assertEquals(emptySet(), KNOWN.keys - wrong.map { it.name }.toSet(), "do no longer differ")
        assertTrue(all.sumOf { it.calls } > 5_000, report)
    }

    @Test
    fun `examples and solutions make the calls of the interpreter on each buggy`() {
        if (!MicroPython.isHere) return
        // Each program on one of the buggies; thorough/EveryBuggyRunTest takes all on all.
        val programs = (examplePrograms + lessonPrograms).toList()
        val runs = allBuggies.keys.withIndex().sumOf { (index, name) ->
            runOnBuggy(name, programs.filterIndexed { at, _ -> at % allBuggies.size == index }.toMap(), KNOWN.keys)
        }
        println("$runs programs on ${allBuggies.size} buggies")
        assertTrue(runs > allBuggies.size * 3, "only $runs")
    }

    private fun report(programs: Int, all: List<BoardComparison>, refused: List<PythonTranslation>) = buildString {
        val calls = all.sumOf { it.calls }
        appendLine("$programs programs: ${all.size} run, ${refused.size} refused, $calls calls are the same")
        all.groupingBy { it.result }.eachCount().forEach { (result, count) -> appendLine("  $count $result") }
        refused.map { it.notes.first { note -> note.isLost }.message }.groupingBy { it }.eachCount()
            .forEach { (message, count) -> appendLine("  $count refused: $message") }
    }

    companion object {
        private val messages = PythonTranslationMessages.of(Language.ENGLISH)
        private val sources =
            testPrograms + documentedPrograms + documentedBoardPrograms + examplePrograms + lessonPrograms

        /** What differs and is meant to, or cannot be seen here. */
        val KNOWN = mapOf(
            "expressions/decimals-are-32-bit.robo" to "decimal numbers of 64 bits",
            "wave.robo" to "decimal numbers of 64 bits: a turn by almost nothing goes the other way",
            "recursion/as-deep-as-a-brick-can.robo" to "a board has less room for calls inside each other",
        )
    }
}
