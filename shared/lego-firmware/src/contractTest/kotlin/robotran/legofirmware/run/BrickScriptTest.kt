package robotran.legofirmware.run

import robotran.legofirmware.instructions.Opcode
import robotran.legofirmware.instructions.OpcodeUse
import robotran.legofirmware.testPrograms
import kotlin.test.Test
import kotlin.test.assertEquals

class BrickScriptTest {
    @Test
    fun `all programs do what their comments say`() {
        val failures = testPrograms.entries.mapNotNull { (name, source) ->
            runCatching { BrickScript(name, source).run() }.exceptionOrNull()?.let { "$name: ${it.message}" }
        }
        assertEquals(emptyList(), failures)
    }

    @Test
    fun `every command of a program is in one of them`() {
        val words = testPrograms.values.flatMap { source ->
            source.lines().map { it.substringBefore(';').trim().substringBefore(' ') }
        }.toSet()
        val missing = Opcode.entries.filter { it.use != OpcodeUse.REQUEST && it.mnemonic !in words }
        assertEquals(listOf(Opcode.POLLD, Opcode.REMOTE), missing)
    }
}
