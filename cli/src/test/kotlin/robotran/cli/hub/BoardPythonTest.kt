package robotran.cli.hub

import robotran.brick.kind.BuggyKind
import robotran.cli.CommandTest
import kotlin.io.path.readText
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse

class BoardPythonTest : CommandTest() {
    private fun run(vararg arguments: String) = commandLine.execute(arguments.toList())

    @Test
    fun `a program becomes Python for a micro-bit on a buggy`() {
        val python = folder.resolve("main.py")
        val arguments = arrayOf("--to", "python", "--brick", "microbit", "--buggy", "cutebot", "-o", "$python")
        assertEquals(0, run("translate", square, *arguments), console.complaints.joinToString())
        assertContains(python.readText(), "The numbers of this Cutebot.")
        assertContains(python.readText(), "        forward(20)\n")
    }

    @Test
    fun `each buggy that is told can be chosen, and has its own bytes`() {
        val all = BuggyKind.entries.map { buggy ->
            assertEquals(0, run("translate", square, "--brick", "microbit", "--buggy", buggy.word), buggy.word)
            console.said.removeLast().also { assertContains(it, "The numbers of this ${buggy.label}.") }
        }
        assertEquals(all.size, all.distinct().size)
        for ((place, buggy) in BuggyKind.entries.withIndex()) {
            assertEquals(0, run("translate", square, "--brick", "microbit-v1", "--buggy", buggy.word), buggy.word)
            assertEquals(figuresIn(all[place]), figuresIn(console.said.last()), "the wheels are those of the buggy")
        }
        for (brick in listOf("microbit", "microbit-v1")) {
            assertEquals(0, run("translate", square, "--brick", brick), console.complaints.joinToString())
        }
    }

    @Test
    fun `the board that a program names needs no option`() {
        val board = program("robot\n  brick microbit\nend\nforward 10")
        assertEquals(0, run("translate", board), console.complaints.joinToString())
        assertContains(console.said.single(), "forward(10)")
        assertEquals(0, run("translate", board, "--buggy", "maqueen"))
        assertContains(console.said.last(), "Maqueen")
    }

    @Test
    fun `a buggy without a micro-bit, and one that is not known, are refused`() {
        assertEquals(2, run("translate", square, "--buggy", "cutebot"))
        assertEquals(2, run("translate", square, "--brick", "spike-prime", "--buggy", "cutebot"))
        assertContains(console.complaints.last(), "--buggy goes with --brick microbit or microbit-v1")
        assertEquals(2, run("translate", square, "--brick", "microbit", "--buggy", "limousine"))
    }

    @Test
    fun `what a buggy cannot do is told with its line`() {
        val program = program("show sensor 4\nbeep")
        assertEquals(1, run("translate", program, "--brick", "microbit"))
        assertContains(console.complaints.first(), "mine.robo:1:")
        assertEquals(0, run("check", square, "--brick", "microbit"))
        assertEquals(1, run("check", program("show battery"), "--brick", "microbit"))
        assertFalse(console.complaints.isEmpty())
    }

    /** How long a centimetre and a degree take. */
    private fun figuresIn(python: String): List<String> =
        python.lines().filter { it.startsWith("CM = ") || it.startsWith("DEG = ") }.also { assertEquals(2, it.size) }
}
