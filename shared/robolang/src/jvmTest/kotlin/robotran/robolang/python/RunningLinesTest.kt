package robotran.robolang.python

import robotran.language.Language
import robotran.robolang.RobolangHubProgram
import robotran.robolang.examplePrograms
import robotran.robolang.lessonPrograms
import robotran.robolang.messages.PythonTranslationMessages
import robotran.robolang.testPrograms
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Programs that tell which line runs, in a real MicroPython on the fake modules, beside those that do not and the interpreter. */
class RunningLinesTest {
    @Test
    fun `a program that tells its lines makes the same calls at the same times`() {
        if (!MicroPython.isHere) return println("MicroPython is not on this machine: not run.")
        val logs = MicroPython.run(
            programs.mapValues { it.value.second.python } +
                programs.map { (name, both) -> name + TELLING to quiet(marked(both, RunningLineLimits.WINDOW).python) },
        )
        val different = programs.keys.filter { name ->
            logs.getValue(name) != logs.getValue(name + TELLING).filterNot { it.startsWith(TOLD) }
        }
        assertEquals(emptyList(), different)
        val told = programs.keys.sumOf { name -> logs.getValue(name + TELLING).count { it.startsWith(TOLD) } }
        assertTrue(told > programs.size * 3, "$told lines are told")
    }

    @Test
    fun `each call stands behind the line that the interpreter says makes it`() {
        if (!MicroPython.isHere) return
        val every = programs.mapValues { marked(it.value, window = 0) }
        val logs = MicroPython.run(every.mapValues { quiet(it.value.python) })
        var compared = 0
        val wrong = programs.mapNotNull { (name, both) ->
            val hub = HubRecorder(both.first.robot.model)
            callsOf(both.first, hub)
            // The end of a program stops the wheels, which no line does.
            val made = linesOfCalls(logs.getValue(name), every.getValue(name))
                .dropLastWhile { it.first == "drive_base brake" }
            val same = made.zip(hub.calls.zip(hub.sourceLines)).takeWhile { (one, other) -> one.first == other.first }
                .filter { (one) -> one.second > 0 }
            compared += same.size
            same.firstOrNull { (one, other) -> one.second != other.second }?.let { "$name: $it" }
        }
        println("$compared calls stand behind their line")
        assertEquals(ELSEWHERE.keys.toList(), wrong.map { it.substringBefore(": ") }, "$wrong")
        assertTrue(compared > 10_000, "$compared")
    }

    @Test
    fun `the line that a program is at for long is told, and never more than Bluetooth takes`() {
        if (!MicroPython.isHere) return
        val limited = programs.mapValues { marked(it.value, RunningLineLimits.WINDOW) }
        val every = programs.mapValues { marked(it.value, window = 0) }
        val logs = MicroPython.run(
            limited.map { (name, python) -> name to timed(python) }.toMap() +
                every.map { (name, python) -> name + TELLING to timed(python) },
        )
        var most = 0
        val missing = programs.keys.mapNotNull { name ->
            val told = toldIn(logs.getValue(name), limited.getValue(name))
            val all = toldIn(logs.getValue(name + TELLING), every.getValue(name))
            assertTrue(told.zipWithNext().none { (one, other) -> one.line == other.line }, name)
            most = maxOf(most, told.maxOfOrNull { first -> told.count { it.time - first.time in 0L..<SECOND } } ?: 0)
            all.zipWithNext().firstOrNull { (at, next) ->
                next.time - at.time > RunningLineLimits.WINDOW &&
                    told.lastOrNull { it.time <= at.time }?.line != at.line
            }?.let { "$name: $it" }
        }
        println("at most $most lines are told in a second")
        assertEquals(emptyList(), missing)
        assertTrue(most <= RunningLineLimits.MOST * SECOND / RunningLineLimits.WINDOW, "$most in a second")
    }

    @Test
    fun `names of the helper make room for those of the program`() {
        val python = markedOf("var at_line = 1\nvar at_last = 2\nshow at_line + at_last")
        assertTrue("def at_line_(line, most=1):" in python, python)
        assertTrue("global at_last_, at_count" in python, python)
    }

    @Test
    fun `marks stand above statements alone`() {
        val python = markedOf("if light < 40\n  beep\nelse if light < 50\n  wait 1 second\nelse\n  beep\nend\n")
        val main = python.lines().dropWhile { !it.trim().startsWith("at_line(") }.map { it.replace(Regex("\\d+"), "0") }
        val wanted = "at_line(0)\nif light_sensor.reflection() < 0:\n    at_line(0, 0)\n    hub.speaker.beep()\n" +
            "elif light_sensor.reflection() < 0:\n    at_line(0, 0)\n    wait(0)\nelse:\n    at_line(0, 0)\n    hub.speaker.beep()\n"
        assertEquals(wanted, main.joinToString("\n"))
    }

    private class Told(val line: Int, val time: Long) {
        override fun toString() = "line $line at $time"
    }

    /** The lines of the program that are told in [log], and when. */
    private fun toldIn(log: List<String>, python: PythonTranslation): List<Told> = log.filter {
        it.startsWith(TOLD)
    }.map { text ->
        val (line, time) = text.removePrefix(TOLD).removeSuffix("\"").split(' ')
        Told(checkNotNull(python.lineMap.sourceLineOf(line.toInt())), time.toLong())
    }

    /** The calls in [log], each with the line that was told before it; 0 for those of the devices, which are made first. */
    private fun linesOfCalls(log: List<String>, python: PythonTranslation): List<Pair<String, Int>> {
        var line = 0
        return log.dropLast(1).mapNotNull { text ->
            if (text.startsWith(TOLD)) {
                line = checkNotNull(python.lineMap.sourceLineOf(text.removePrefix(TOLD).removeSuffix("\"").toInt()))
                null
            } else {
                text to line
            }
        }
    }

    /** [python] so that it also tells the time of the fake modules. */
    private fun timed(python: PythonTranslation): String {
        val text = python.python.replace("%d\" % line)", "%d %d\" % (line, at_state.clock))")
        check(text != python.python)
        return "from fake_hub import state as at_state\n${quiet(text)}"
    }

    /** [python] whose own clock may be asked often: the fake modules end a program that only asks. */
    private fun quiet(python: String): String {
        val text = python.replace("at_clock.time() >=", "at_clock_time() >=")
        check(text != python)
        val clock = "def at_clock_time():\n    return at_now.clock - at_clock.start\n"
        return "from fake_hub import state as at_now\n$clock$text"
    }

    private fun marked(both: Pair<RobolangHubProgram, PythonTranslation>, window: Int) =
        withRunningLines(both.first, both.second, SIGN, window)

    private fun markedOf(text: String): String {
        val program = checkNotNull(programForHub(text, "test.robo"))
        return withRunningLines(program, translateToPython(program, program.robot, messages), SIGN).python
    }

    private companion object {
        const val SIGN = '\u001E'
        const val TOLD = "print \"$SIGN"
        const val TELLING = " telling its lines"
        const val SECOND = 1000

        /** Where another line is told than the one that makes a call, and why. */
        val ELSEWHERE = mapOf(
            "functions/that-moves-inside-an-expression.robo" to
                "the line that calls goes on after a function that moves",
            "functions/that-waits.robo" to "the same after one that waits",
            "light-seeker.robo" to "the same after one that turns",
        )
        val messages = PythonTranslationMessages.of(Language.ENGLISH)

        /** All that a hub can do, with their Python. */
        val programs: Map<String, Pair<RobolangHubProgram, PythonTranslation>> =
            (testPrograms + examplePrograms + lessonPrograms)
                .mapNotNull { (name, text) -> programForHub(text, name)?.let { name to it } }
                .associate { (name, program) ->
                    name to (program to translateToPython(program, program.robot, messages))
                }
                .filterValues { it.second.isComplete && reasonNotToCompare(it.first) == null }
    }
}
