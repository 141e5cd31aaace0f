package robotran.robolang.translate

import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class NxtKitTest {
    private val source = "robot\n  brick nxt\nend\nforward 20\n"
    private val files = kitFiles(translationOf(source, "my square.robo"), "my square.robo", source)

    private fun text(name: String): String = files.single { it.path == "MySquare/$name" }.text

    @Test
    fun `the kit for an NXT has the program and what its own tools need`() {
        val names = listOf("MySquare.java", "my square.robo", "README.txt", "build.xml", "upload.sh", "upload.bat")
        assertEquals(names.map { "MySquare/$it" }, files.map { it.path })
        assertContains(text("MySquare.java"), "import lejos.nxt.*;")
        assertEquals(source, text("my square.robo"))
        assertTrue(files.single { it.isExecutable }.path.endsWith("upload.sh"))
    }

    @Test
    fun `each script compiles, links and uploads`() {
        for (name in listOf("upload.sh", "upload.bat", "build.xml")) {
            val places = listOf("nxjc", "nxjlink", "nxjupload").map { tool -> text(name).lastIndexOf(tool) }
            assertEquals(places.sorted(), places, name)
            assertTrue(places.all { it > 0 }, name)
            assertContains(text(name), "MySquare.nxj")
            assertFalse("lejosc" in text(name), name)
        }
        assertFalse('\n' in text("upload.bat").replace("\r\n", ""))
    }

    @Test
    fun `the figures that the instructions explain are in the Java`() {
        for (figure in listOf("WHEEL_DIAMETER", "TRACK_WIDTH")) {
            assertContains(text("README.txt"), figure)
            assertContains(text("MySquare.java"), "static final float $figure = ")
        }
    }
}
