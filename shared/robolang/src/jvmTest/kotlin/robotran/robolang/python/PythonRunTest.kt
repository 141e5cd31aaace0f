package robotran.robolang.python

import robotran.language.Language
import robotran.robolang.RobolangHubProgram
import robotran.robolang.documentedPrograms
import robotran.robolang.examplePrograms
import robotran.robolang.lessonPrograms
import robotran.robolang.messages.PythonTranslationMessages
import robotran.robolang.oraclePrograms
import robotran.robolang.recordedPython
import robotran.robolang.testPrograms
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/**
 * Translations are run by a real MicroPython on fake modules of Pybricks, and their calls are those of the interpreter.
 *
 * MicroPython for Node has whole numbers without limit and decimal numbers of 64 bits: the fake modules refuse numbers
 * beyond 31 bits where they come in, and decimal numbers are compared with a tolerance.
 */
class PythonRunTest {
    @Test
    fun `translations of all programs run without an error and make the calls of the interpreter`() {
        if (!MicroPython.isHere) return println("MicroPython is not on this machine: not run.")
        val (complete, refused) = translations().toList().partition { it.second.isComplete }
        val logs = MicroPython.run(complete.associate { (name, translation) -> name to translation.python })
        val all = complete.map { (name, _) ->
            compareOnHub(name, programs.getValue(name), logs.getValue(name))
        }
        val wrong = all.filter { it.isWrong }
        val report = report(all, refused.map { it.second })
        println(report)
        assertEquals(emptyList(), wrong.filter { it.name !in KNOWN }.map { it.toString() }, report)
        assertEquals(emptySet(), KNOWN.keys - wrong.map { it.name }.toSet(), "do no longer differ")
        assertTrue(all.sumOf { it.calls } > 20_000, report)
    }

    @Test
    fun `translations of examples and solutions run on each hub without an error`() {
        if (!MicroPython.isHere) return
        val robots = listOf(sonarRobot, essentialRobot, technicRobot, ev3Robot, nxtRobot)
        val programs = examplePrograms + lessonPrograms
        val complete = robots.flatMap { robot ->
            programs.mapNotNull { (name, text) -> programForHub(text, name, robot)?.let { name to it } }
                .map { (name, program) -> "${robot.model} $name" to translateToPython(program, robot, messages) }
        }.filter { it.second.isComplete }
        val logs = MicroPython.run(complete.associate { (name, translation) -> name to translation.python })
        assertTrue(logs.size > programs.size * 2, "only ${logs.size} translations are complete")
        val failed = logs.filterValues { it.last().startsWith("# error") }
        assertEquals(emptyMap(), failed)
    }

    @Test
    fun `translations print what the same programs printed on a hub`() {
        if (!MicroPython.isHere) return
        val recorded = recordedPythonSources.keys.associateWith {
            recordedPython[it.removeSuffix(".robo") + ".out.txt"]
        }
            .mapNotNull { (name, printed) -> printed?.let { name to it } }
        assertTrue(recorded.size >= 4)
        val texts = recorded.associate { (name, _) -> name to recordedPythonSources.getValue(name) }
        val logs = MicroPython.run(
            texts.mapValues { (name, text) ->
                pythonOf(text, hubRobotFor(text), name = name).python
            },
        )
        for ((name, printed) in recorded) {
            val lines = logs.getValue(name).filter { it.startsWith("print") }
            val wanted = printed.lines().filter { it.isNotEmpty() }.map { "print \"$it\"" }
            val isAlike = lines.size == wanted.size && lines.zip(wanted).all { (one, other) -> areAlike(one, other) }
            assertTrue(isAlike, "$name: $lines, not $wanted")
        }
    }

    @Test
    fun `the fake modules print what a hub printed`() {
        if (!MicroPython.isHere) return
        val logs = MicroPython.run(oraclePrograms.filterKeys { it.endsWith(".py") })
        assertTrue(logs.size >= 13)
        for ((name, log) in logs) {
            val lines = log.filter { it.startsWith("print") }.map { it.removePrefix("print \"").removeSuffix("\"") }
            val wanted = oraclePrograms.getValue(name.removeSuffix(".py") + ".out").lines()
                .takeWhile { it != TRACEBACK }.filter { it.isNotEmpty() && it != STOPPED }
            val different = lines.zip(wanted).filterNot { (one, other) -> areAlikeWordByWord(one, other) }
            assertEquals(wanted.size, lines.size, name)
            assertEquals(OTHER_LINES[name] ?: 0, different.size, "$name: $different")
        }
    }

    private fun areAlikeWordByWord(first: String, second: String): Boolean {
        val words = first.split(' ').zip(second.split(' '))
        return first.count { it == ' ' } == second.count { it == ' ' } &&
            words.all { (one, other) -> areAlike("print \"$one\"", "print \"$other\"") }
    }

    private val programs: Map<String, RobolangHubProgram> by lazy {
        compiled(testPrograms + documentedPrograms + examplePrograms + lessonPrograms + recordedPythonSources)
    }

    private fun compiled(sources: Map<String, String>): Map<String, RobolangHubProgram> =
        sources.mapNotNull { (name, text) -> programForHub(text, name)?.let { name to it } }.toMap()

    private fun translations(): Map<String, PythonTranslation> =
        programs.mapValues { (_, program) -> translateToPython(program, program.robot, messages) }

    private fun report(all: List<HubComparison>, refused: List<PythonTranslation>): String = buildString {
        val calls = all.sumOf { it.calls }
        appendLine("${programs.size} programs: ${all.size} run, ${refused.size} refused, $calls calls are the same")
        all.groupingBy { it.result }.eachCount().forEach { (result, count) -> appendLine("  $count $result") }
        refused.map { it.notes.first { note -> note.isLost }.message }.groupingBy { it }.eachCount()
            .forEach { (message, count) -> appendLine("  $count refused: $message") }
    }

    private companion object {
        val messages = PythonTranslationMessages.of(Language.ENGLISH)

        /** What the hub itself prints. */
        const val TRACEBACK = "Traceback (most recent call last):"
        const val STOPPED = "The program was stopped (SystemExit)."

        /** How many lines of a recorded program are others in Node: numbers beyond 31 and 32 bits, the type of a task. */
        val OTHER_LINES = mapOf(
            "01-integers.py" to 2,
            "02-decimals.py" to 4,
            "03-functions.py" to 1,
            "23-task-mistakes.py" to 1,
        )

        /** What differs and is meant to, or cannot be seen here. */
        val KNOWN = mapOf(
            "behaviours/an-action-that-ends-its-own-condition.robo" to "nothing looks at conditions between two waits",
            "behaviours/interrupts-between-statements.robo" to "nothing looks at conditions between two waits",
            "expressions/decimals-are-32-bit.robo" to "decimal numbers of 64 bits",
            "expressions/tangent.robo" to "decimal numbers of 64 bits",
            "tree.robo" to "decimal numbers of 64 bits",
            "sound/tone-of-no-length.robo" to "a tone of no length is a call on a hub",
            "lessons/sense/08-ring/solution.robo" to "a hub looks every 10 milliseconds",
        )
    }
}
