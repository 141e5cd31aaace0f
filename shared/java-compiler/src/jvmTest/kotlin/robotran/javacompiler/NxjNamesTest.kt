package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import org.eclipse.jdt.internal.compiler.classfmt.ClassFileConstants
import org.eclipse.jdt.internal.compiler.classfmt.ClassFileReader
import robotran.javacompiler.diagnose.namesAbsentFromNxj
import robotran.javacompiler.diagnose.namesWithNxjCode
import robotran.javacompiler.diagnose.nxjCode
import robotran.javacompiler.messages.JavaMessages
import robotran.javacompiler.messages.NxjRemedy
import robotran.language.Language
import robotran.nxjlibrary.NxjDifferences
import robotran.nxjlibrary.NxjLibrary
import kotlin.test.Test
import kotlin.test.assertEquals

class NxjNamesTest {
    private suspend fun classes(): Map<String, ClassFileReader> =
        NxjLibrary.load().classFilesOfBrick.entries.associate { (name, file) ->
            name.substringAfterLast('/') to ClassFileReader(file, name.toCharArray())
        }

    @Test
    fun `nothing that the library has is said to be absent`() = runTest {
        val classes = classes()
        val wrong = namesAbsentFromNxj.filter { name ->
            val owner = classes[name.substringBefore('.')]
            val member = name.substringAfter('.', "")
            owner != null && (member.isEmpty() || member in membersOf(owner))
        }
        assertEquals(emptyList(), wrong)
    }

    @Test
    fun `code is told only for what leJOS NXJ lacks at least with some parameters`() = runTest {
        val classes = classes()
        val lacking = NxjDifferences.all.map { "${it.owner.substringAfterLast('/')}.${it.name}" }.toSet()
        val wrong = namesWithNxjCode.filter { name ->
            val member = name.substringAfter('.')
            generateSequence(classes.getValue(name.substringBefore('.'))) { type ->
                type.superclassName?.let { classes[String(it).substringAfterLast('/')] }
            }.any { type ->
                member in membersOf(type) && "${String(type.name).substringAfterLast('/')}.$member" !in lacking
            }
        }
        assertEquals(emptyList(), wrong)
    }

    @Test
    fun `no sentence recommends what leJOS NXJ lacks`() = runTest {
        val there = classes().values.flatMap(::membersOf).toSet()
        val lacking = NxjDifferences.all.map { it.name }.filterNot { it in there }.toSet()
        val messages =
            listOf(
                JavaMessages.of(Language.ENGLISH),
                JavaMessages.of(Language.GERMAN),
                JavaMessages.of(Language.SPANISH),
            )
        val described = messages.flatMap { language -> NxjRemedy.entries.map(language::insteadInNxj) } + nxjCodes
        val wrong = described.filter { sentence -> WORD.findAll(sentence).any { it.value in lacking } }
        assertEquals(emptyList(), wrong)
    }

    private val nxjCodes = namesWithNxjCode.mapNotNull { name ->
        nxjCode(
            name.substringAfter('.'),
            name.substringBefore('.'),
            JavaMessages.of(Language.ENGLISH),
        )
    }

    private fun membersOf(type: ClassFileReader): Set<String> {
        val methods = type.methods.orEmpty().filter { it.modifiers and ClassFileConstants.AccSynthetic == 0 }
        val fields = type.fields.orEmpty().filter { it.modifiers and ClassFileConstants.AccPrivate == 0 }
        return (methods.map { String(it.selector) } + fields.map { String(it.name) }).toSet()
    }

    private companion object {
        val WORD = Regex("""\w+(?=\()""")
    }
}
