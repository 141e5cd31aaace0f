package robotran.lejoslibrary

import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull

class LejosLibraryTest {
    @Test
    fun `every class has a class file of version 45`() {
        for (name in LejosLibrary.classNames) {
            val bytes = assertNotNull(LejosLibrary.classFile(name))
            assertEquals(listOf(0xCA, 0xFE, 0xBA, 0xBE, 0, 3, 0, 45), bytes.take(8).map { it.toInt() and 0xFF }, name)
        }
    }

    @Test
    fun `inner classes share the source of their outer class`() {
        assertContains(LejosLibrary.classNames, "josx/robotics/Arbitrator\$Actor")
        assertEquals(
            LejosLibrary.source("josx/robotics/Arbitrator"),
            LejosLibrary.source("josx/robotics/Arbitrator\$Actor"),
        )
    }

    @Test
    fun `what a brick lacks is not there`() {
        for (name in listOf("java/lang/Runnable", "java/util/ArrayList", "java/lang/Double", "java/io/PrintStream")) {
            assertNull(LejosLibrary.classFile(name), name)
            assertNull(LejosLibrary.source(name), name)
        }
    }

    @Test
    fun `every class begins with a sentence of help`() {
        for (name in LejosLibrary.classNames.filterNot { '$' in it }) {
            val help = Regex("""/\*\*\s+(?:\* )?([A-Z][^.]*[.])""").find(assertNotNull(LejosLibrary.source(name)))
            assertNotNull(help, name)
        }
    }
}
