package robotran.cli.translate

import robotran.cli.CommandTest
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeText
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class TranslateCommandTest : CommandTest() {
    private fun translate(vararg arguments: String) = commandLine.execute(listOf("translate") + arguments)

    @Test
    fun `the Java goes to the console`() {
        assertEquals(0, translate(square))
        assertContains(console.said.single(), "public class Square {")
        assertContains(console.said.single(), "// Draws a square. Make it a triangle.")
    }

    @Test
    fun `the Java goes to a file`() {
        val java = folder.resolve("java/Square.java")
        assertEquals(0, translate(square, "-o", "$java"))
        assertContains(java.readText(), "forwardCentimetres(20);")
        assertEquals(emptyList(), console.said)
    }

    @Test
    fun `several programs go to the console one after the other`() {
        assertEquals(0, translate(square, tree.resolve("examples/star.robo").path))
        assertEquals(
            listOf("Square", "Star"),
            console.said.map { it.substringAfter("public class ").substringBefore(" ") },
        )
    }

    @Test
    fun `several programs do not fit into one file`() {
        for (option in listOf("-o", "--kit")) {
            assertEquals(2, translate(square, square, option, "$folder/all"))
            assertContains(console.complaints.last(), "one program at a time")
        }
    }

    @Test
    fun `a program with mistakes is not translated`() {
        val wrong = folder.resolve("wrong.robo").also { it.writeText("hop\n") }
        val java = folder.resolve("Wrong.java")
        assertEquals(1, translate("$wrong", "-o", "$java"))
        assertTrue(console.complaints.single().startsWith("$wrong:1:1: "))
        assertFalse(java.exists())
    }

    @Test
    fun `a program that is not there is refused in one sentence`() {
        assertEquals(2, translate("$folder/missing.robo"))
        assertContains(console.complaints.single(), "missing.robo")
    }
}
