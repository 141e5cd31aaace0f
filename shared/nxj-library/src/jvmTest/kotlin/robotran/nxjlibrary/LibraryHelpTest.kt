package robotran.nxjlibrary

import kotlin.test.Test
import kotlin.test.assertEquals

/** What the app shows as help is there for everything that a program can use. */
class LibraryHelpTest {
    private val help = library.classNames.filter { '$' !in it }.sorted()
        .mapNotNull { name -> sources.source(name)?.let { name to JavaHelp(it) } }.toMap().filterValues { it.isPublic }

    @Test
    fun `every public class and member begins with a sentence for a pupil`() {
        val silent = help.flatMap { (name, help) ->
            (help.ofMembers + (name to help.ofClass)).filter { it.second.isEmpty() }.map { "$name: ${it.first}" }
        }
        assertEquals(emptyList(), silent)
    }

    @Test
    fun `no sentence of help is longer than two lines of a tablet`() {
        val long = help.flatMap { (name, help) ->
            (help.ofMembers + (name to help.ofClass)).filter { it.second.length > LONGEST }
        }
        assertEquals(emptyList(), long)
    }

    private companion object {
        const val LONGEST = 160
    }
}
