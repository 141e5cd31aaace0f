package robotran.nxt

import robotran.nxt.program.NxtNative
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class NxtScriptTest {
    @Test
    fun `the brick does what every script says`() {
        assertTrue(nxtScripts.size >= 40, "only ${nxtScripts.size} scripts were found")
        assertEquals(
            "",
            nxtScripts.flatMap { (path, text) -> NxtScript(path, text).differences() }.joinToString("\n"),
        )
    }

    @Test
    fun `every call of a program is made by a script`() {
        val made = Regex("""^(?:call|library) (\w+)""", RegexOption.MULTILINE)
            .findAll(nxtScripts.values.joinToString("\n")).map { it.groupValues[1] }.toSet()
        val byNoProgram = setOf(NxtNative.BIT_BLT, NxtNative.EXCEPTION)
        assertEquals(
            emptyList(),
            (NxtNative.entries - byNoProgram).map { it.nativeName }.filter { it !in made },
        )
    }
}
