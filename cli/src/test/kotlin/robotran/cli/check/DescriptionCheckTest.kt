package robotran.cli.check

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import robotran.cli.CommandTest
import robotran.world.file.BuiltInWorlds
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals

class DescriptionCheckTest : CommandTest() {
    private fun check(vararg arguments: String) = commandLine.execute(listOf("check") + arguments)

    private val world = BuiltInWorlds.texts.getValue("plain.world.json")
    private val misspelt = world.replaceFirst("\"walls\"", "\"wals\"")
    private val note = "wals is not known and does nothing; perhaps \"walls\" is meant."

    private val course =
        """{"format": "robotran-course", "version": 1, "title": "C", "assignments": ["one.robotran"]}"""

    private fun assignment(idName: String = "id"): String =
        """
        { "format": "robotran-project", "version": 1,
          "assignment": { "$idName": "a-1", "mayChangWorld": true },
          "world": $world }
        """.trimIndent()

    @Test
    fun `the worlds and robots that come with Robotran have no mistakes`() {
        val files = tree.resolve("worlds").listFiles { file -> Regex(".*\\.(world|robot)\\.json").matches(file.name) }
        assertEquals(0, check(*files.orEmpty().map { it.path }.toTypedArray()), "${console.complaints}")
        assertEquals(files.orEmpty().size, console.said.size, "${console.said}")
    }

    @Test
    fun `a misspelt field of a world is a warning, and its name does not matter`() {
        for (name in listOf("a.world.json", "A.WORLD.JSON", "a.json", "a.txt")) {
            val file = program(misspelt, name)
            console.said.clear()
            assertEquals(0, check(file))
            assertContains(console.said.first(), "$file: Line ")
            assertContains(console.said.first(), note)
            assertEquals("$file has no mistakes.", console.said.last())
        }
    }

    @Test
    fun `mistakes of robots, assignments and courses are told`() {
        assertEquals(1, check(program("""{ "format": "robotran-robot", "version": 1 }""", "a.robot.json")))
        assertContains(console.complaints.last(), "title is missing")
        assertEquals(1, check(program(assignment("ID"), "one.robotran")))
        assertContains(console.complaints.last(), "assignment.id is missing; perhaps \"ID\" is meant for it.")
        assertEquals(1, check(program("{ 'format': 1 }", "b.world.json")))
        assertContains(console.complaints.last(), "a text stands in double quotes: \"format\".")
        assertEquals(0, check(program(assignment(), "one.robotran")))
        assertContains(console.said.joinToString("\n"), "perhaps \"mayChangeWorld\" is meant")
        console.said.clear()
        assertEquals(0, check(program(course, "course.json")))
        assertContains(console.said.first(), "one.robotran: Line ")
        console.said.clear()
        assertEquals(0, check("$folder"))
        assertContains(console.said.first(), "perhaps \"mayChangeWorld\" is meant")
    }

    @Test
    fun `as JSON each has its line and its path`() {
        val file = program(misspelt, "a.world.json")
        assertEquals(1, check("--json", file, program("{\n}\n}", "b.world.json")))
        val found = Json.parseToJsonElement(console.said.last()).jsonArray.map { it.jsonObject }
        val warning = found[0].getValue("diagnostics").jsonArray.single().jsonObject
        assertEquals("warning", warning.getValue("severity").jsonPrimitive.content)
        assertEquals("wals", warning.getValue("path").jsonPrimitive.content)
        val error = found[1].getValue("diagnostics").jsonArray.single().jsonObject
        assertEquals("mistake", error.getValue("severity").jsonPrimitive.content)
        assertEquals("3", error.getValue("line").jsonPrimitive.content)
    }

    @Test
    fun `run, grade and robot tell misspelt fields, too, and go on`() {
        val file = program(misspelt, "a.world.json")
        assertEquals(0, commandLine.execute(listOf("run", square, "--world", file, "--for", "1")))
        assertContains(console.complaints.joinToString("\n"), note)
        console.complaints.clear()
        val goals = program(
            misspelt.replaceFirst("\"atLeast\": 40", "\"atMost\": 900"),
            "b.world.json",
        )
        commandLine.execute(listOf("grade", goals, square))
        assertContains(console.complaints.joinToString("\n"), note)
        console.complaints.clear()
        val robot = program(
            """{ "format": "robotran-robot", "version": 1, "title": "Wide", "wheels": { "trak": 12 } }""",
            "wide.robot.json",
        )
        assertEquals(0, commandLine.execute(listOf("robot", robot)))
        assertContains(console.complaints.single(), "perhaps \"track\" is meant")
    }

    @Test
    fun `other files are told what can be checked`() {
        assertEquals(2, check(program("hello", "a.txt")))
        assertContains(console.complaints.single(), ".world.json")
    }
}
