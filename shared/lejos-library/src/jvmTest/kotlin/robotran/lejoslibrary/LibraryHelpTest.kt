package robotran.lejoslibrary

import kotlin.test.Test
import kotlin.test.assertEquals

/** What the app shows as help is there for everything that a program can use. */
class LibraryHelpTest {
    private val help = libraryHelp

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

    @Test
    fun `as many members have help as the class files have`() {
        val members = libraryClassFiles.filter { it.isPublic && '$' !in it.className }.associate { type ->
            val methods = type.methods.count { (it.isPublic || it.isProtected) && it.name != "<clinit>" }
            val fields = type.fields.count { it.isPublic || it.isProtected }
            type.className.replace('.', '/') to methods + fields
        }
        assertEquals(members.toSortedMap(), help.mapValues { it.value.ofMembers.size }.toSortedMap())
    }

    private companion object {
        const val LONGEST = 160
    }
}
