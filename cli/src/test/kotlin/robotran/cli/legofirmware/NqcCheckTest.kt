package robotran.cli.legofirmware

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import robotran.cli.CommandTest
import kotlin.io.path.readText
import kotlin.io.path.writeBytes
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Tests `check`, `format` and `grade` with programs for LEGO's own firmware. */
class NqcCheckTest : CommandTest() {
    private fun execute(vararg arguments: String): Int {
        console.said.clear()
        console.complaints.clear()
        return commandLine.execute(arguments.toList())
    }

    private val examples = tree.resolve("examples/nqc").listFiles { file -> file.extension == "nqc" }.orEmpty()
        .map { it.path }.toTypedArray()

    @Test
    fun `every example has no mistakes and is laid out`() {
        assertEquals(0, execute("check", *examples), console.complaints.joinToString("\n"))
        assertEquals(examples.size, console.said.size)
        assertEquals(0, execute("format", "--check", *examples), console.complaints.joinToString("\n"))
    }

    @Test
    fun `solutions of worlds have no mistakes and nothing to warn of`() {
        val solutions = tree.resolve("learning/worlds").walk().filter {
            it.name == "solution.nqc"
        }.map { it.path }.toList()
        assertTrue(solutions.size >= 3, solutions.toString())
        assertEquals(0, execute("check", *solutions.toTypedArray()))
        assertEquals(emptyList(), console.complaints.toList())
    }

    @Test
    fun `old programs in the encoding of Windows are read`() {
        val old = folder.resolve("old.nqc")
        old.writeBytes("// f\u00FCr Mia\ntask main() { }\n".toByteArray(Charsets.ISO_8859_1))
        assertEquals(0, execute("check", "$old"), console.complaints.joinToString("\n"))
        val other = folder.resolve("old.robo")
        other.writeBytes("# f\u00FCr Mia\nbeep\n".toByteArray(Charsets.ISO_8859_1))
        assertEquals(1, minOf(1, execute("check", "$other")))
    }

    @Test
    fun `format lays a program out`() {
        val untidy = program("task main()\n{\nWait(1);\n}", "untidy.nqc")
        assertEquals(1, execute("format", "--check", untidy))
        assertEquals(0, execute("format", untidy))
        assertEquals("task main()\n{\n    Wait(1);\n}\n", folder.resolve("untidy.nqc").readText())
    }

    private val header = program("void go()\n{\n  onfwd(OUT_A);\n}\n", "moves.nqh")
    private val main = program("#include \"moves.nqh\"\ntask main()\n{\n  go();\n}\n", "main.nqc")

    @Test
    fun `a mistake in an included file is told with that file`() {
        assertEquals(1, execute("check", main))
        assertTrue(console.complaints.single().startsWith("$header:3:3: "), console.complaints.single())
    }

    @Test
    fun `JSON names the included file of a mistake`() {
        assertEquals(1, execute("check", main, "--json"))
        val file = Json.parseToJsonElement(console.said.single()).jsonArray.single().jsonObject
        assertEquals(main, file.getValue("file").jsonPrimitive.content)
        val error = file.getValue("diagnostics").jsonArray.single().jsonObject
        assertEquals(listOf(header, "3"), listOf("file", "line").map { error.getValue(it).jsonPrimitive.content })
    }

    @Test
    fun `a warning does not fail the check`() {
        val odd = program("\ttask 0\n\tgpwr 7, 2, 3\n\tping\n\tpollm 1, 2\n\tendt\n", "odd.lasm")
        assertEquals(0, execute("check", odd), console.complaints.joinToString())
        assertTrue(console.said.any { "odd.lasm:4:" in it && "(a warning)" in it }, console.said.joinToString())
    }

    @Test
    fun `an image is checked`() {
        val image = program("RCXI", "cut.rcx")
        assertEquals(1, execute("check", image))
        assertTrue(console.complaints.single().startsWith("$image: "), console.complaints.single())
    }

    @Test
    fun `hand-ins in NQC, as images and as assembly text are graded`() {
        val world = program(
            """{"format": "robotran-world", "version": 2, "title": "Ahead", "paper": {"width": 100, "height": 80},
               "robots": [{"start": {"x": 20, "y": 40, "heading": 0}}], "timeLimit": 8,
               "goals": [{"kind": "reach", "region": {"circle": {"x": 60, "y": 40, "radius": 8}}, "stays": true}]}""",
            "ahead.world.json",
        )
        val good = program(
            "#include \"go.nqh\"\ntask main()\n{\n  SetPower(OUT_AC, OUT_HALF);\n  go();\n}\n",
            "class/ann/good.nqc",
        )
        program("void go()\n{\n  OnFwd(OUT_AC);\n  Wait(200);\n  Off(OUT_AC);\n}\n", "class/ann/go.nqh")
        assertEquals(0, execute("build", good, "-o", "$folder/class/bob.rcx"))
        assertEquals(0, execute("translate", good, "-o", "$folder/class/carl.lasm"))
        program("task main() { }\n", "class/dora.nqc")
        assertEquals(0, execute("grade", world, good))
        assertEquals(1, execute("grade", world, "$folder/class", "--csv", "-"))
        val rows = console.said.joinToString("\n").lines().filter { it.isNotBlank() }.drop(1)
        assertEquals(4, rows.size, rows.joinToString("\n"))
        assertContains(rows.joinToString(), "ann")
        assertContains(rows.joinToString(), "bob")
    }
}
