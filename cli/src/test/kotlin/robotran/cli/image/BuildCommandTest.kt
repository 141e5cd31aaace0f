package robotran.cli.image

import robotran.cli.CommandTest
import kotlin.io.path.exists
import kotlin.io.path.readBytes
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class BuildCommandTest : CommandTest() {
    private val image = folder.resolve("out/square.bin")

    private fun build(vararg arguments: String) = commandLine.execute(listOf("build") + arguments)

    @Test
    fun `a Robolang program becomes an image, and its size and the room left are told`() {
        assertEquals(0, build(square, "-o", image.toString()))
        val bytes = image.readBytes()
        assertEquals(listOf(0xCA, 0xF6), bytes.take(2).map { it.toInt() and 0xFF })
        val left = 13888 - bytes.size
        val said = "$image has ${bytes.size} bytes. On the brick, $left bytes are left for objects, arrays and texts."
        assertEquals(listOf(said), console.said)
    }

    @Test
    fun `leJOS 2 has room for more`() {
        assertEquals(0, build(javaProgram("Hello", "Sound.beep();"), "--lejos", "2.1"))
        assertEquals(0, build(javaProgram("Hello", "Sound.beep();")))
        val (of21, of30) = console.said.map { Regex("(\\d+) bytes are left").find(it)!!.groupValues[1].toInt() }
        assertEquals(14780 - 13888, of21 - of30)
    }

    @Test
    fun `without a file for it the image is only measured`() {
        assertEquals(0, build(javaProgram("Hello", "Sound.beep();")))
        assertContains(console.said.single(), "The program takes ")
        assertFalse(image.exists())
    }

    @Test
    fun `several programs share one image`() {
        val java = javaProgram("Hello", "Sound.beep();")
        assertEquals(0, build(square, java, "-o", image.toString(), "--listing"))
        val listing = console.said.first()
        assertContains(listing, "Programs:\n  0 Square\n  1 Hello\n")
    }

    @Test
    fun `the listing tells the image in words`() {
        assertEquals(0, build(javaProgram("Hello", "Sound.beep();"), "--listing"))
        val lines = console.said.first().lines()
        assertTrue(lines.first().startsWith("An image of "), lines.first())
        assertContains(lines, "  0 java.lang.Object  objects of 4 bytes")
        assertContains(lines, "  17 Hello: java.lang.Object  objects of 4 bytes")
        assertContains(lines, "  0 main([Ljava/lang/String;)V")
    }

    @Test
    fun `a mistake that only a brick notices has file, line and sentence`() {
        val file = javaProgram("Grid", "String[][] names = new String[2][3];\nnames[0][0] = \"\";")
        assertEquals(1, build(file, "-o", image.toString()))
        assertContains(console.complaints.single(), "$file:5:1: Grid.main: The brick cannot create arrays of objects")
        assertFalse(image.exists())
    }

    @Test
    fun `mistakes of all programs are told, each with its file`() {
        val robolang = program("beep\nbep\n")
        val java = javaProgram("Hello", "int x = true;")
        assertEquals(1, build(robolang, java))
        val (first, second) = console.complaints
        assertTrue(first.startsWith("$robolang:2:1: "), first)
        assertTrue(second.startsWith("$java:5:"), second)
    }

    @Test
    fun `a file that is not there is bad input`() {
        assertEquals(2, build("missing.robo"))
        assertEquals(2, build())
    }

    @Test
    fun `German pupils read German`() {
        assertEquals(0, build(square, "--language", "de"))
        assertContains(console.said.single(), "Auf dem Stein bleiben ")
    }
}
