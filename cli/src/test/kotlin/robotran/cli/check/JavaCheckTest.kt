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

/** Tests `robotran check` with Java sources. */
class JavaCheckTest : CommandTest() {
    private fun check(vararg arguments: String) = commandLine.execute(listOf("check") + arguments)

    @Test
    fun `every Java example has no mistakes`() {
        val examples = tree.resolve("examples/lejos").listFiles { file -> file.extension == "java" }.orEmpty()
        assertTrue(examples.isNotEmpty())
        for (example in examples) assertEquals(0, check(example.path), console.complaints.joinToString("\n"))
        assertEquals(examples.map { "${it.path} has no mistakes." }, console.said)
    }

    @Test
    fun `all mistakes of all files are told with their places, beside those of a Robolang program`() {
        val main = javaProgram("Main", "new Robot().drive();\nMotor.A.forwrd();")
        val robolang = program("forwrd 20\n")
        val robot = program("public class Robot {\n    void drive() {\n        hop();\n    }\n}\n", "Robot.java")
        assertEquals(1, check(main, robolang, robot))
        assertEquals(
            listOf("$main:6:17", "$robolang:1:1", "$robot:3:9"),
            console.complaints.map { it.substringBefore(": ") },
        )
    }

    @Test
    fun `what a brick does not have is a mistake`() {
        val file = javaProgram("Choose", "switch (args.length) {\n    case 1: LCD.clear();\n}")
        assertEquals(1, check(file))
        assertContains(console.complaints.single(), "$file:5:")
        assertContains(console.complaints.single(), "\"switch\"")
    }

    @Test
    fun `a program that begins nowhere is one`() {
        val file = program("public class Nothing {\n}\n", "Nothing.java")
        assertEquals(1, check(file))
        assertContains(console.complaints.single(), "\"main\"")
    }

    @Test
    fun `a file that cannot be read, or is no text of a program, weighs more than mistakes`() {
        assertEquals(2, check(javaProgram("Main", "hop();"), "$folder/Missing.java"))
        assertEquals(listOf(true, false), console.complaints.map { "Main.java:5" in it })
        console.complaints.clear()
        assertEquals(2, check("$folder/Missing.java"))
        assertEquals(listOf("There is no file $folder/Missing.java."), console.complaints)
        console.complaints.clear()
        val text = program("hop();", "Main.txt")
        assertEquals(2, check(text))
        assertEquals(
            listOf(
                "$text cannot be checked: its name does not end in .robo, .java, .class, .jar, .nqc, .lasm, .rcx, " +
                    ".world.json, .robot.json, .robotran or .course.json.",
            ),
            console.complaints,
        )
    }

    @Test
    fun `JSON has every mistake with its range and its fix`() {
        val main = javaProgram("Main", "Motor.A.forwrd();")
        val other = program("public class Other {\n}\n", "Other.java")
        assertEquals(1, check(main, other, "--json"))
        val (mistaken, ready) = Json.parseToJsonElement(console.said.single()).jsonArray.map { it.jsonObject }
        assertEquals(listOf(main, other), listOf(mistaken, ready).map { it.getValue("file").jsonPrimitive.content })
        val diagnostic = mistaken.getValue("diagnostics").jsonArray.single().jsonObject
        val place = listOf("severity", "line", "column", "endColumn").map {
            diagnostic.getValue(it).jsonPrimitive.content
        }
        assertEquals(listOf("mistake", "5", "17", "23"), place)
        assertContains(diagnostic.getValue("message").jsonPrimitive.content, "\"forwrd\"")
        assertEquals("forward", diagnostic.getValue("fix").jsonObject.getValue("replacement").jsonPrimitive.content)
        assertEquals(0, ready.getValue("diagnostics").jsonArray.size)
    }
}
