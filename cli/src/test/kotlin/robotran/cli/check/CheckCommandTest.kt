package robotran.cli.check

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import robotran.cli.CommandTest
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class CheckCommandTest : CommandTest() {
    private fun check(vararg arguments: String) = commandLine.execute(listOf("check") + arguments)

    @Test
    fun `every example has no mistakes`() {
        val examples = tree.resolve("examples").listFiles { file -> file.extension == "robo" }.orEmpty().map { it.path }
        assertTrue(examples.isNotEmpty())
        assertEquals(0, check(*examples.toTypedArray()), console.complaints.joinToString("\n"))
        assertEquals(examples.size, console.said.size)
    }

    @Test
    fun `all mistakes of all files are told with their places`() {
        val first = program("foward 20\nbeep\nturn 90\n", "first.robo")
        val second = program("pen\n", "second.robo")
        assertEquals(1, check(first, square, second))
        val places = listOf("$first:1:1: ", "$first:3:5: ", "$second:1:4: ")
        assertEquals(places.size, console.complaints.size)
        places.zip(console.complaints).forEach { (place, complaint) ->
            assertTrue(complaint.startsWith(place), complaint)
        }
        assertContains(console.said.single(), "square.robo has no mistakes.")
    }

    @Test
    fun `a file that cannot be read weighs more than mistakes`() {
        assertEquals(2, check(program("hop\n", "wrong.robo"), "$folder/missing.robo"))
        assertEquals(2, console.complaints.size)
    }

    @Test
    fun `JSON has every mistake with its code, its range and its fix`() {
        val wrong = program("foward 20 // \"go\"\n", "wrong.robo")
        assertEquals(1, check(wrong, square, "--json"))
        val (mistaken, ready) = Json.parseToJsonElement(console.said.single()).jsonArray.map { it.jsonObject }
        assertEquals(wrong, mistaken.getValue("file").jsonPrimitive.content)
        val diagnostic = mistaken.getValue("diagnostics").jsonArray.single().jsonObject
        val described = listOf("code", "severity", "line", "column", "endColumn", "text").map {
            diagnostic.getValue(it).jsonPrimitive.content
        }
        assertEquals(listOf("unknown-command", "mistake", "1", "1", "7", "foward"), described)
        assertContains(diagnostic.getValue("message").jsonPrimitive.content, "\"foward\"")
        val fix = diagnostic.getValue("fix").jsonObject
        assertEquals(
            listOf("1", "1", "7", "forward"),
            listOf("line", "column", "endColumn", "replacement").map {
                fix.getValue(it).jsonPrimitive.content
            },
        )
        assertEquals(0, ready.getValue("diagnostics").jsonArray.size)
        assertEquals(emptyList(), console.complaints)
    }

    @Test
    fun `what a build for a real brick would refuse is a remark, with --lejos a mistake`() {
        val many = program((1..250).joinToString("\n", postfix = "\n") { "show ${40_000 + it}" })
        assertEquals(1, commandLine.execute(listOf("build", many)))
        val refused = console.complaints.map { it.substringAfter(": ") }
        console.complaints.clear()
        assertEquals(0, check(many))
        assertEquals(emptyList(), console.complaints)
        val notes = console.said.filter { "A real brick would refuse this program. " in it }
        assertEquals(refused.size, notes.size)
        assertTrue(notes.all { it.endsWith(" (a warning)") }, "$notes")
        assertContains(console.said.last(), "has no mistakes.")
        assertEquals(1, check(many, "--lejos", "3.0"))
        assertEquals(refused, console.complaints.map { it.substringAfter(": ") })
    }

    @Test
    fun `what the robot of a brick does not have is a remark at its line`() {
        val coloured = program("if colour == red\n  forward 10\nend\n", "red.robo")
        assertEquals(0, check(coloured, "--brick", "spike-prime"))
        assertEquals(1, console.said.size, "${console.said}")
        assertEquals(0, check(coloured, "--brick", "spike-essential"))
        val told = console.said.single { "This robot has no colour sensor." in it }
        assertTrue(told.startsWith("$coloured:1:4: "), told)
        assertEquals(emptyList(), console.complaints)
    }

    @Test
    fun `no file is no check`() {
        assertEquals(2, check())
    }
}
