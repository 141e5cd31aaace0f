package robotran.nxjlibrary

import kotlinx.coroutines.test.runTest
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertSame

class NxjLibraryTest {
    @Test
    fun `every class has a class file of version 50`() = runTest {
        val library = NxjLibrary.load()
        assertContains(library.classNames, "lejos/nxt/Motor")
        for (name in library.classNames) {
            val bytes = assertNotNull(library.classFile(name))
            assertEquals(listOf(0xCA, 0xFE, 0xBA, 0xBE, 0, 0, 0, 50), bytes.take(8).map { it.toInt() and 0xFF }, name)
        }
    }

    @Test
    fun `all get the same library`() = runTest {
        assertSame(NxjLibrary.load(), NxjLibrary.load())
        assertSame(NxjLibrary.load().classFiles, NxjLibrary.load().classFiles)
        assertSame(NxjSources.load(), NxjSources.load())
    }

    @Test
    fun `every class begins with a sentence of help`() = runTest {
        val sources = NxjSources.load()
        for (name in NxjLibrary.load().classNames.filterNot { '$' in it }) {
            val source = sources.source(name) ?: continue // a second class of a file
            assertNotNull(Regex("""/\*\*\s+(?:\* )?([A-Z][^.]*[.])""").find(source), name)
        }
    }

    @Test
    fun `inner classes share the source of their outer class`() = runTest {
        val sources = NxjSources.load()
        assertContains(NxjLibrary.load().classNames, "lejos/robotics/navigation/Move\$MoveType")
        assertNotNull(sources.source("lejos/robotics/navigation/Move"))
        assertEquals(
            sources.source("lejos/robotics/navigation/Move"),
            sources.source("lejos/robotics/navigation/Move\$MoveType"),
        )
    }

    @Test
    fun `members that leJOS NXJ lacks are known through subclasses, too`() = runTest {
        val library = NxjLibrary.load()
        val get = "get(I)Ljava/lang/Object;"
        assertEquals(NxjDifference("java/util/Vector", get), library.differenceFor("java/util/Stack", get))
        assertNull(library.differenceFor("java/util/ArrayList", get))
        assertEquals("get", library.differenceFor("java/util/Vector", get)?.name)
    }

    @Test
    fun `compilers do not see members that leJOS NXJ lacks`() = runTest {
        val library = NxjLibrary.load()
        val differing = library.classNames.filterNot { name ->
            library.classFile(name).contentEquals(library.classFilesOfBrick[name])
        }
        assertEquals(NxjDifferences.all.map { it.owner }.toSet(), differing.toSet())
    }

    @Test
    fun `what leJOS NXJ lacks is not there`() = runTest {
        val absent =
            listOf("java/util/Collections", "java/util/Scanner", "java/util/TreeMap", "java/util/LinkedHashMap")
        for (name in absent) assertNull(NxjLibrary.load().classFile(name), name)
    }
}
