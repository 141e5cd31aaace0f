package robotran.robolang.translate

import robotran.brick.kind.BrickKind
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
        val names = listOf("MySquare.java", "my square.robo") + README + SCRIPTS
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

    @Test
    fun `the kit of a Java program compiles all of its files`() {
        val sources = listOf(KitFile("Walk.java", "package robots;"), KitFile("Helper.java", "package robots;"))
        val files = javaKitFiles("robots/Walk", sources, BrickKind.NXT)
        assertEquals((listOf("Walk.java", "Helper.java") + README + SCRIPTS).map { "Walk/$it" }, files.map { it.path })
        for (name in SCRIPTS) {
            val script = files.single { it.path == "Walk/$name" }.text
            assertContains(script, "-d . Walk.java Helper.java")
            assertContains(script, "-o Walk.nxj robots.Walk")
        }
        for (name in README) assertContains(files.single { it.path == "Walk/$name" }.text, "Walk.java")
    }

    private companion object {
        val README = listOf("README.txt", "LIESMICH.txt", "LEEME.txt")
        val SCRIPTS = listOf("build.xml", "upload.sh", "upload.bat")
    }
}
