package robotran.robolang.python

import robotran.language.Language
import robotran.robolang.documentedPrograms
import robotran.robolang.examplePrograms
import robotran.robolang.recordedPython
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.SyntaxTree
import robotran.robolang.syntax.allStatements
import robotran.robolang.testPrograms
import robotran.robolang.translate.linesWithJava
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** The programs that the recorded translations are of, by name. */
internal val recordedPythonSources: Map<String, String> = recordedPython.filterKeys { it.endsWith(".robo") }

class TranslateToPythonTest {
    @Test
    fun `translations are as recorded`() {
        assertTrue(recordedPythonSources.size >= 10)
        for ((name, source) in recordedPythonSources) {
            val recorded = recordedPython[name.removeSuffix(".robo") + ".py.txt"]
            assertEquals(recorded, pythonOf(source, hubRobotFor(source), name = name).python, name)
        }
    }

    @Test
    fun `only what is used is imported, in alphabetical order`() {
        val all = allPrograms.values.map { it.python }
        for (python in all) {
            val imports = python.lines().filter { it.startsWith("from ") }
            assertEquals(imports.sorted(), imports)
            val rest = python.lines().filterNot {
                it.startsWith("from ") || it.trimStart().startsWith("#")
            }.joinToString("\n")
            for (line in imports) {
                val names = line.substringAfter("import ").split(", ")
                assertEquals(names.sorted(), names)
                for (name in names) {
                    assertTrue(
                        Regex("\\b$name\\b").containsMatchIn(rest),
                        "$name is not used in\n$python",
                    )
                }
            }
        }
    }

    @Test
    fun `devices and functions that the program does not use are not there`() {
        for (python in allPrograms.values.map { it.python }) {
            val made = Regex("""(?m)^(\w+) = [A-Z]\w*\(""").findAll(python).map { it.groupValues[1] }
            val functions = Regex(
                """(?m)^(?:async )?def (divide|remainder|show|blink|distance|pen_\w+|my_turn|whenever)\(""",
            )
                .findAll(python).map { it.groupValues[1] }
            for (name in made + functions) {
                assertTrue(Regex("\\b$name\\b").findAll(python).count() > 1, "$name is not used in\n$python")
            }
        }
    }

    @Test
    fun `each line of each program has its lines of Python and they lead back to it`() {
        val problems = allPrograms.filterValues { it.isComplete }.flatMap { (name, translation) ->
            val tree = checkNotNull(programForHub(sources.getValue(name), name)).checked.tree
            (linesWithJava(tree) - linesOfEnds(tree)).filter { line ->
                val lines = translation.lineMap.targetLinesOf(line)
                lines.isEmpty() || lines.any { translation.lineMap.sourceLineOf(it) != line }
            }.map { "$name:$it" }
        }
        assertEquals(emptyList(), problems)
    }

    @Test
    fun `each comment is in the Python once`() {
        val source = "// about it\n\n// first\nbeep // loud\n" +
            "repeat 2 times\n  // in it\n  buzz\n  // below\nend // of it\n// closing"
        val lines = pythonLinesOf(source)
        assertEquals("# about it", lines.first())
        val place = lines.indexOf("# first")
        val expected = listOf(
            "# first",
            "hub.speaker.beep()  # loud",
            "for _ in range(2):",
            "    # in it",
            "    hub.speaker.beep(100, 500)",
            "    # below",
            "    # of it",
            "# closing",
        )
        assertEquals(expected, lines.subList(place, place + expected.size))
    }

    @Test
    fun `notes are told once each, in the language of the pupil`() {
        val source = "forward 20\nforward 30\nshow light\nshow light / 2\nshow \"HELLO\"\nshow \"HELLO\"\npower 0"
        val all = Language.entries.map { language -> pythonOf(source, language = language).notes.map { it.message } }
        for (notes in all) assertEquals(notes.distinct(), notes)
        assertEquals(1, all.map { it.size }.distinct().size)
        assertEquals(Language.entries.size, all.distinct().size)
    }

    @Test
    fun `what is missing is told at its place and leaves a comment`() {
        val translation = pythonOf("forward 20\nwait until distance < 50\nbeep")
        val note = translation.notes.single { it.isLost }
        assertEquals(2, note.range.line)
        assertContains(translation.python.lines(), "# ${note.message}")
    }

    @Test
    fun `the wheels of a robot are written to the thousandth`() {
        val robot = bumperRobot.copy(wheelDiameter = 49.6, track = 114.25)
        val lines = pythonLinesOf("forward 20", robot)
        assertContains(lines, "left_motor = Motor(Port.A, Direction.COUNTERCLOCKWISE)")
        assertContains(lines, "robot = DriveBase(left_motor, right_motor, wheel_diameter=49.6, axle_track=114.25)")
    }

    private companion object {
        val sources = testPrograms + documentedPrograms + examplePrograms

        /** The translations of all valid programs. */
        val allPrograms: Map<String, PythonTranslation> by lazy {
            sources.filter { (name, text) -> programForHub(text, name) != null }
                .mapValues { (name, text) -> pythonOf(text, hubRobotFor(text), name = name) }
        }
    }
}

/** Lines with `end` have no Python. */
internal fun linesOfEnds(tree: SyntaxTree): Set<Int> = (
    tree.routines.map { it.endRange } + tree.behaviours.map { it.endRange } +
        allStatements(tree).mapNotNull { (it as? Statement.Block)?.endRange }
).map { it.line }.toSet()
