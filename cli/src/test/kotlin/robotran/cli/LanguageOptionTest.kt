package robotran.cli

import kotlin.io.path.writeText
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class LanguageOptionTest : CommandTest() {
    private val wrong = program("foward 20\n", "wrong.robo")
    private val world = folder.resolve("ahead.world.json").also {
        it.writeText(
            """{"format": "robotran-world", "version": 2, "title": "Ahead", "paper": {"width": 100, "height": 80},
               "robots": [{"start": {"x": 50, "y": 40, "heading": 0}}], "timeLimit": 8,
               "goals": [{"kind": "inkLength", "atLeast": 10.5}]}""",
        )
    }.toString()

    private fun execute(vararg arguments: String): Int {
        console.said.clear()
        console.complaints.clear()
        return commandLine.execute(arguments.toList())
    }

    @Test
    fun `check tells mistakes in the language that is asked for`() {
        execute("check", wrong)
        assertEquals(
            "$wrong:1:1: There is no command \"foward\". Did you mean \"forward\"?",
            console.complaints.single(),
        )
        execute("check", "--language", "es", wrong)
        assertEquals(
            "$wrong:1:1: No existe la orden \"foward\". ¿Querías decir \"forward\"?",
            console.complaints.single(),
        )
        execute("check", "--language", "de", wrong)
        assertEquals(
            "$wrong:1:1: Es gibt keinen Befehl \"foward\". Meinst du \"forward\"?",
            console.complaints.single(),
        )
        execute("check", "--language", "de", square)
        assertEquals("$square hat keine Fehler.", console.said.single())
    }

    @Test
    fun `check tells mistakes of Java too`() {
        val java = javaProgram("Wrong", "int x = 1")
        assertEquals(1, execute("check", "--language", "de", java))
        assertContains(console.complaints.single(), "Ans Ende dieser Anweisung gehört ein \";\".")
    }

    @Test
    fun `run tells how it ended`() {
        val program = program("pen down\nforward 20\n")
        assertEquals(0, execute("run", program, "--world", world, "--language", "de"))
        assertContains(console.said.single(), "Das Programm war nach ")
        assertContains(console.said.single(), "Der Roboter ist bei x 70,0 cm")
        assertContains(console.said.single(), "geschafft: Zeichne 10,5 cm oder mehr.")
        assertEquals(1, execute("run", program("var zero = 0\nshow 1 / zero\n"), "--language", "es"))
        assertEquals("Línea 2: 1 no se puede dividir entre 0.", console.complaints.single())
    }

    @Test
    fun `grade tells what was missed`() {
        val program = program("forward 20\n")
        assertEquals(1, execute("grade", world, program, "--language", "es"))
        assertContains(console.said.single(), "Dibuja 10,5 cm o más.")
        assertContains(console.said.single(), "0 de 1 semillas")
        execute("grade", world, program, "--language", "de")
        assertContains(console.said.single(), "0 von 1 Startzahlen")
    }

    @Test
    fun `format, translate and link tell it too`() {
        execute("format", "--check", "--language", "de", program("  beep\n"))
        assertContains(console.complaints.single(), "ist nicht ordentlich gesetzt.")
        execute("translate", "--language", "es", wrong)
        assertContains(console.complaints.single(), "No existe la orden")
        execute("link", "--language", "de", "$folder/missing.robo")
        assertEquals("Es gibt keine Datei $folder/missing.robo.", console.complaints.single())
    }

    @Test
    fun `files that cannot be used are told in every language`() {
        execute("run", "--language", "es", "$folder/missing.robo")
        assertEquals("No existe el archivo $folder/missing.robo.", console.complaints.single())
        execute("run", "--language", "de", square, "--world", program("{}", "empty.world.json"))
        assertContains(console.complaints.single(), "Das ist keine Welt von Robotran")
    }

    @Test
    fun `a language that Robotran does not speak is refused`() {
        assertEquals(2, execute("check", "--language", "it", square))
        assertTrue(
            console.complaints.single().contains("it is none of en, es, de, fr, pt"),
            console.complaints.single(),
        )
    }
}
