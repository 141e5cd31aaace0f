package robotran.nqc

import robotran.language.Language
import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.image.toBytes
import robotran.nqc.messages.NqcMessages
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class VectorTest {
    @Test
    fun `programs for firmware 2 become the images of the original compiler`() = check(FirmwareTarget.RCX2)

    @Test
    fun `programs for firmware 1 become the images of the original compiler`() = check(FirmwareTarget.RCX)

    @Test
    fun `there are twenty programs`() = assertEquals(20, Vectors.programs.size)

    private fun check(target: FirmwareTarget) {
        val failures = Vectors.programs.mapNotNull { (name, source) ->
            val result =
                compileNqc("$name.nqc", source, NqcOptions(target), messages = NqcMessages.of(Language.ENGLISH))
            val expected = Vectors.image(name, target)
            val actual = (result as? NqcResult.Success)?.program?.image?.toBytes()?.joinToString(" ") { hex(it) }
            if (expected == actual) null else "$name: ${describe(result)}\nexpected $expected\nactual   $actual"
        }
        assertTrue(failures.isEmpty(), failures.joinToString("\n\n"))
    }

    private fun describe(result: NqcResult): String =
        (result as? NqcResult.Failure)?.diagnostics?.joinToString { "${it.range?.line}: ${it.message}" }
            ?: "other bytes"

    private fun hex(byte: Byte) = (byte.toInt() and 0xFF).toString(16).padStart(2, '0')
}
