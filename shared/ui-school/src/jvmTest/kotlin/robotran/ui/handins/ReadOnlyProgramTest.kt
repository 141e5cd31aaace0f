package robotran.ui.handins

import robotran.language.ProgramLanguage
import robotran.workshop.handins.equalLines
import kotlin.test.Test
import kotlin.test.assertEquals

class ReadOnlyProgramTest {
    @Test
    fun `lines in the words of different languages are equal if they say the same`() {
        val german = usualLines("vorwärts 20\ndrehe links 90", ProgramLanguage.ROBOLANG)
        val spanish = usualLines("adelante 20\ngira izquierda 45", ProgramLanguage.ROBOLANG)
        assertEquals(listOf(true, false), equalLines(german, spanish))
    }
}
