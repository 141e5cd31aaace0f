package robotran.robolang.format

import robotran.language.Language
import robotran.robolang.documentedPrograms
import robotran.robolang.examplePrograms
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.testPrograms
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class FormatTest {
    @Test
    fun `blocks are indented by two spaces`() = assertFormatted(
        "repeat 2 times\nif light<40\nbeep\nelse if left bumper\nbuzz\nelse\nstop\nend\nend",
        "repeat 2 times\n  if light < 40\n    beep\n  else if left bumper\n    buzz\n  else\n    stop\n  end\nend\n",
    )

    @Test
    fun `keywords are in lower case and names as they are first written`() = assertFormatted(
        "VAR Side = 5\nFORWARD side CM\nmotor a FORWARD",
        "var Side = 5\nforward Side cm\nmotor A forward\n",
    )

    @Test
    fun `pieces have one space between them`() = assertFormatted(
        "var x=( 1+2 )*- 3\nshow   -x\nshow x -1\nshow max( x ,[ 1,2 ] [ 0 ])\nforward(20)",
        "var x = (1 + 2) * -3\nshow -x\nshow x - 1\nshow max(x, [1, 2][0])\nforward (20)\n",
    )

    @Test
    fun `comments behind neighbouring lines stand one under the other`() = assertFormatted(
        "beep // one\nforward 20 // two\n\nbeep // three",
        "beep        // one\nforward 20  // two\n\nbeep  // three\n",
    )

    @Test
    fun `a comment on its own line is indented with its block`() = assertFormatted(
        "repeat 2 times\n// why\nbeep\nend\n   // done",
        "repeat 2 times\n  // why\n  beep\nend\n// done\n",
    )

    @Test
    fun `one empty line at most is kept and none at the edges`() =
        assertFormatted("\n\nbeep\n\n\n\nbeep\n\n", "beep\n\nbeep\n")

    @Test
    fun `nothing stays nothing`() = assertFormatted("\n \n", "")

    @Test
    fun `a program that cannot be read is left alone`() {
        val result =
            assertIs<FormatResult.Failure>(
                formatRobolang("foward 20", messages = RobolangMessages.of(Language.ENGLISH)),
            )
        assertEquals("There is no command \"foward\". Did you mean \"forward\"?", result.diagnostics.single().message)
    }

    @Test
    fun `a name that nothing declares is no mistake of layout`() = assertFormatted("forward  side", "forward side\n")

    @Test
    fun `all programs keep their meaning and stay as they are when formatted again`() {
        val programs = testPrograms + examplePrograms + documentedPrograms
        assertTrue(programs.size > 100)
        programs.values.forEach(::checkFormatting)
    }

    private fun assertFormatted(source: String, expected: String) = assertEquals(
        FormatResult.Success(expected),
        formatRobolang(source, messages = RobolangMessages.of(Language.ENGLISH)),
    )
}
