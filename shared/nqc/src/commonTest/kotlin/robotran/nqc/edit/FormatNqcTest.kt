package robotran.nqc.edit

import robotran.language.Language
import robotran.nqc.NqcResult
import robotran.nqc.Vectors
import robotran.nqc.compileNqc
import robotran.nqc.messages.NqcMessages
import kotlin.test.Test
import kotlin.test.assertEquals

class FormatNqcTest {
    @Test
    fun `blocks are indented`() {
        val source = """
            |#define GO(x) OnFwd(x); \
            |   Wait(10)
            |task main() {
            |while (true)
            |{
            |  if (SENSOR_1 == 1)
            |  Off(OUT_A);
            |else {   OnFwd(OUT_A);
            |  }
            |     }
            |
            |
            |/* a
            |comment */
            |    }
        """.trimMargin()
        val expected = """
            |#define GO(x) OnFwd(x); \
            |   Wait(10)
            |task main() {
            |    while (true)
            |    {
            |        if (SENSOR_1 == 1)
            |            Off(OUT_A);
            |        else {   OnFwd(OUT_A);
            |        }
            |    }
            |
            |    /* a
            |    comment */
            |}
            |
        """.trimMargin()
        assertEquals(expected, NqcSyntax.format(source))
    }

    @Test
    fun `formatting twice changes nothing, and programs stay the same`() {
        for ((name, source) in Vectors.programs) {
            val formatted = NqcSyntax.format(source)
            assertEquals(formatted, NqcSyntax.format(formatted), name)
            assertEquals(codeOf(source), codeOf(formatted), name)
        }
    }

    private fun codeOf(source: String) = (
        compileNqc(
            "f.nqc",
            source,
            messages = NqcMessages.of(Language.ENGLISH),
        ) as? NqcResult.Success
    )?.program?.image?.chunks
}
