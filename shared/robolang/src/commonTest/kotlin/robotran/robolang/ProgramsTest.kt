package robotran.robolang

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class ProgramsTest {
    @Test
    fun `every test program does what its comments say`() {
        assertTrue(testPrograms.size >= 40, "only ${testPrograms.size} test programs were found")
        assertEquals("", differencesIn(testPrograms))
    }

    @Test
    fun `every test program says what it expects`() {
        assertEquals(emptyList(), testPrograms.filterValues { Expectations(it).isEmpty }.keys.toList())
    }

    @Test
    fun `every program in the document does what its comments say`() {
        assertTrue(documentedPrograms.isNotEmpty(), "no programs were found in the document")
        assertEquals("", differencesIn(documentedPrograms))
    }

    @Test
    fun `every example runs to its end without a mistake`() {
        assertTrue(examplePrograms.isNotEmpty(), "no examples were found")
        assertEquals("", differencesIn(examplePrograms))
    }

    private fun differencesIn(programs: Map<String, String>): String =
        programs.flatMap { (path, text) -> differencesOrFailure(TestProgram(path, text)) }.joinToString("\n")

    /** One program that does not come to its end must not keep the others from being looked at. */
    private fun differencesOrFailure(program: TestProgram): List<String> =
        try {
            differences(program)
        } catch (failure: AssertionError) {
            listOf(failure.message.orEmpty())
        }
}
