package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import org.eclipse.jdt.internal.compiler.classfmt.ClassFileReader
import robotran.javacompiler.diagnose.namesAbsentFromNxj
import robotran.nxjlibrary.NxjLibrary
import kotlin.test.Test
import kotlin.test.assertEquals

class NxjNamesTest {
    @Test
    fun `nothing that the library has is said to be absent`() = runTest {
        val classes = NxjLibrary.load().classFiles.entries.associate { (name, file) ->
            name.substringAfterLast('/') to ClassFileReader(file, name.toCharArray())
        }
        val wrong = namesAbsentFromNxj.filter { name ->
            val owner = classes[name.substringBefore('.')]
            val member = name.substringAfter('.', "")
            owner != null && (member.isEmpty() || member in membersOf(owner))
        }
        assertEquals(emptyList(), wrong)
    }

    private fun membersOf(type: ClassFileReader): Set<String> =
        (type.methods.orEmpty().map { String(it.selector) } + type.fields.orEmpty().map { String(it.name) }).toSet()
}
