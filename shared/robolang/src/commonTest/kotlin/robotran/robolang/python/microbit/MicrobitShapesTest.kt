package robotran.robolang.python.microbit

import robotran.brick.kind.BuggyKind
import robotran.brick.kind.BuggyPins
import robotran.brick.kind.PlainDrive
import robotran.language.Language
import robotran.microbit.model.MicrobitModel
import robotran.robolang.documentedPrograms
import robotran.robolang.examplePrograms
import robotran.robolang.python.PythonTranslation
import robotran.robolang.python.linesOfEnds
import robotran.robolang.testPrograms
import robotran.robolang.translate.linesWithJava
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNotNull
import kotlin.test.assertTrue

/** What Python for a micro:bit looks like. */
class MicrobitShapesTest {
    @Test
    fun `only what is used is imported and defined`() {
        for ((name, translation) in allPrograms) {
            val python = translation.python
            val lines = python.lines().filterNot { it.trimStart().startsWith("#") }
            val imported =
                lines.filter { it.startsWith("from ") }.flatMap { it.substringAfter("import ").split(", ") } +
                    lines.filter { it.startsWith("import ") }.map { it.removePrefix("import ") }
            val defined = lines.mapNotNull { DEFINED.find(it)?.groupValues?.get(1) }
            val pupils = Regex("(?m)^ *(procedure|function|prozedur|funktion) *(\\w+)", RegexOption.IGNORE_CASE)
                .findAll(sources.getValue(name)).map { it.groupValues[2].lowercase() }.toSet()
            val code = lines.filterNot { it.startsWith("from ") || it.startsWith("import ") }.joinToString("\n")
            for (word in imported + defined.filter { it.lowercase() !in pupils }) {
                val least = if (word in defined) 2 else 1
                val uses = Regex("\\b$word\\b").findAll(code).count()
                assertTrue(uses >= least, "$name: $word is not used in\n$python")
            }
        }
    }

    @Test
    fun `nothing is newer than MicroPython 1-9-2`() {
        for ((name, translation) in allPrograms) {
            for (line in translation.python.lines()) {
                val code = line.substringBefore("  # ").trimStart()
                if (code.startsWith("#")) continue
                assertFalse(NEWER.containsMatchIn(code), "$name: $line")
            }
        }
    }

    @Test
    fun `wheels are stopped at the start and whatever happens`() {
        for ((name, translation) in allPrograms) {
            val lines = translation.python.trimEnd().lines()
            assertEquals(listOf("finally:", "    stop()"), lines.takeLast(2), name)
            assertContains(lines, "start()", name)
        }
    }

    @Test
    fun `each line of each program has its lines of Python and they lead back to it`() {
        val problems = allPrograms.filterValues { it.isComplete }.flatMap { (name, translation) ->
            val tree = assertNotNull(programForBoard(sources.getValue(name), name)).checked.tree
            (linesWithJava(tree) - linesOfEnds(tree)).filter { line ->
                val lines = translation.lineMap.targetLinesOf(line)
                lines.isEmpty() || lines.any { translation.lineMap.sourceLineOf(it) != line }
            }.map { "$name:$it" }
        }
        assertEquals(emptyList(), problems.filterNot { problem -> NOTHING_TO_DO.any { problem.startsWith(it) } })
    }

    @Test
    fun `a square is short, with the numbers of the robot at the top`() {
        val python = boardPythonOf(
            "// A square.\nrepeat 4 times\n  forward 20\n  turn left 90\nend",
            trimmedCutebot,
        ).python
        val wanted = listOf("# A square.", "CM = 50", "DEG = 3.3161", "LEFT = 45", "RIGHT = 44", "for _ in range(4):")
        val lines = python.lines().map { it.trim().substringBefore("  # ") }
        assertEquals(wanted, lines.filter { it in wanted })
        assertContains(lines, "forward(20)")
        assertContains(lines, "turn_left(90)")
    }

    @Test
    fun `numbers are only guarded where they need it`() {
        val plain = boardPythonOf(
            "var i = 0\nvar a = [1, 2, 3]\nrepeat 5 times\n  i = i + 1\nend\n" +
                "for k from 0 to 2\n  show a[k] * 10 + i\nend\nshow i / 2 + i mod 3\nforward i * 5",
        ).python
        for (helper in listOf("wrap(", "divide(", "remainder(", "item(", "fail(")) {
            assertFalse(helper in plain, "$helper in\n$plain")
        }
        val guarded = boardPythonOf(
            "var a = 1\nvar l = [1, 2]\nrepeat 40 times\n  a = a * 3\nend\n" +
                "show a / (a - 1)\nshow l[a mod 2]\nrepeat a times\n  beep\nend",
        ).python
        for (part in listOf("a = wrap(a * 3)", "divide(a, wrap(a - 1), 6)", "item(l, remainder", "range(")) {
            assertContains(guarded, part)
        }
        assertContains(guarded, "in times(a, 8):")
    }

    @Test
    fun `names that the translation needs get an underscore`() {
        val lines = boardPythonOf("var i2c = 3\nprocedure wheels()\n  beep\nend\nforward i2c\nwheels()").python.lines()
        assertContains(lines.map { it.trim() }, "forward(i2c_)")
        assertContains(lines.map { it.trim() }, "wheels_()")
    }

    @Test
    fun `what a board lacks is told with what to do instead`() {
        fun lost(source: String, kind: BuggyKind = BuggyKind.CUTEBOT) =
            boardPythonOf(source, buggyRobot(kind)).notes.filter { it.isLost }.map { it.message }
        assertContains(lost("show distance", BuggyKind.PLAIN).single(), "distance sensor")
        assertContains(lost("motor B forward", BuggyKind.TINY_BIT).single(), "A and C")
        assertContains(lost("show sensor 4").single(), "no sensor 4")
        assertEquals(emptyList(), lost("motor B forward\nshow sensor 3\nshow light"))
        val told = boardPythonOf("wait until left bumper\nshow light\nforward 10\nshow 12").notes
        assertEquals(listOf(1, 2, 2, 3), told.map { it.range.line })
    }

    @Test
    fun `notes are told once each, in the language of the pupil`() {
        val source = "forward 20\nforward 30\nshow light\nshow light\nshow \"HELLO\"\nwait until right bumper"
        val all = Language.entries.map { language ->
            boardPythonOf(source, language = language).notes.map { it.message }
        }
        for (notes in all) assertEquals(notes.distinct(), notes)
        assertEquals(listOf(4), all.map { it.size }.distinct())
        assertEquals(Language.entries.size, all.distinct().size)
    }

    @Test
    fun `a V1 makes no tone that would move a servo or a motor on pin 0`() {
        val source = "function high()\n  show 7\n  return 440\nend\nbeep\nplay high() for 0.5 seconds\npen down"
        val motorOnSound = BuggyPins(PlainDrive.BRIDGE, listOf(0, 8), listOf(16, 14))
        val silent = listOf(
            buggyRobot(BuggyKind.KITRONIK_MOVE, MicrobitModel.V1),
            buggyRobot(BuggyKind.PLAIN, MicrobitModel.V1),
            buggyRobot(BuggyKind.PLAIN, MicrobitModel.V1, motorOnSound),
        )
        for (robot in silent) {
            val translation = boardPythonOf(source, robot)
            assertFalse("music" in translation.python, translation.python)
            assertContains(translation.python, "    high()\n    sleep(500)")
            assertTrue(translation.notes.any { it.range.line == 5 && "no sound" in it.message })
        }
        val loud = listOf(
            buggyRobot(BuggyKind.CUTEBOT, MicrobitModel.V1),
            buggyRobot(BuggyKind.KITRONIK_MOVE, MicrobitModel.V1).copy(pen = null),
            buggyRobot(BuggyKind.PLAIN, pins = motorOnSound),
            buggyRobot(BuggyKind.KITRONIK_MOVE),
        )
        for (robot in loud) assertContains(boardPythonOf(source, robot).python, "music.pitch(880")
    }

    @Test
    fun `a V1 has room for small programs only`() {
        val v1 = buggyRobot(BuggyKind.CUTEBOT, MicrobitModel.V1)

        fun notesOf(text: String) = boardPythonOf(text, v1).notes.filter { "memory" in it.message }
        val line = "forward 10\n"
        assertEquals(emptyList(), notesOf(line.repeat(100)))
        assertFalse(notesOf(line.repeat(101)).single().isLost)
        val long = notesOf("beep\n".repeat(101)).single()
        assertFalse(long.isLost)
        assertTrue(long.range.line in 50..80, "${long.range}")
        val tooLong = notesOf(line.repeat(251)).single()
        assertTrue(tooLong.isLost)
        assertTrue(tooLong.range.line in 150..251, "${tooLong.range}")
        assertTrue(assertNotNull(boardPythonOf(line.repeat(251), v1).room).memoryShare > 1f)
        assertTrue(boardPythonOf(line.repeat(251)).isComplete)
    }

    @Test
    fun `how full a board gets is what MicroPython needed, comments not counted`() {
        val v1 = buggyRobot(BuggyKind.CUTEBOT, MicrobitModel.V1)
        val room = assertNotNull(boardPythonOf("forward 10\n", v1).room)
        val commented = assertNotNull(boardPythonOf("// Ahead, a little way.\n\nforward 10\n", v1).room)
        assertEquals(room.memoryBytes, commented.memoryBytes)
        assertTrue(commented.bytes > room.bytes)
        val (sign, letter) = listOf("#", "a").map { boardPythonOf("show \"1${it}2\"\n", v1).room }
        assertEquals(letter, sign)
        assertEquals(10_240, room.heapBytes)
        assertEquals(28_214, room.mostBytes)
        val v2 = assertNotNull(boardPythonOf("forward 10\n").room)
        assertEquals(listOf(65_536, 20_150), listOf(v2.heapBytes, v2.mostBytes))
        assertEquals(room.memoryBytes, v2.memoryBytes)
        assertTrue(v2.memoryShare < 0.1f && room.memoryShare in 0.2f..0.5f, "${v2.memoryShare} ${room.memoryShare}")
    }

    private companion object {
        val DEFINED = Regex("""^(?:def|class) (\w+)""")
        val NEWER = Regex("""\bf"|:=|\bnonlocal\b|\basync\b|\bawait\b|\bmatch\b|^\w+: |->|\bdef .*\*""")
        val sources = testPrograms + documentedPrograms + examplePrograms

        /** Programs with lines that a buggy does nothing for: a tone of no length, a pen that is not there. */
        val NOTHING_TO_DO = listOf("sound/tone-of-no-length.robo")

        /** The translations of all valid programs. */
        val allPrograms: Map<String, PythonTranslation> by lazy {
            sources.filter { (name, text) -> programForBoard(text, name) != null }
                .mapValues { (name, text) -> boardPythonOf(text, name = name) }
        }
    }
}
