package robotran.cli

import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals

class LanguageVariableTest : CommandTest() {
    @Test
    fun `without an option the variable of the environment says the language, and an option counts more`() {
        val file = program("penn down\n", "slip.robo").toString()
        val inFrench = CommandLine(console, desktop = null, variable = mapOf("ROBOTRAN_LANGUAGE" to "fr")::get)
        assertEquals(1, inFrench.execute(listOf("check", file)))
        assertContains(console.complaints.toString(), "Il n'y a pas de commande \"penn\".")
        assertEquals(1, inFrench.execute(listOf("check", file, "--language", "en")))
        assertContains(console.complaints.toString(), "There is no command \"penn\".")
    }
}
