package robotran.nxjlibrary

import org.apache.bcel.classfile.FieldOrMethod
import org.apache.bcel.classfile.JavaClass
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertSame

class NxjDifferencesTest {
    private val classes = libraryClasses.associateBy { it.className.replace('.', '/') }
    private val classesOfBrick = library.classFilesOfBrick.mapValues { (name, file) -> parsed(name, file) }

    @Test
    fun `every difference names a member that programs can use`() {
        val unknown = NxjDifferences.all.filter { difference ->
            val member = classes[difference.owner]?.let(::membersOf)?.get(difference.member)
            member == null || !(member.isPublic || member.isProtected)
        }
        assertEquals(emptyList(), unknown)
    }

    @Test
    fun `nothing is named twice`() = assertEquals(NxjDifferences.all.distinct(), NxjDifferences.all)

    @Test
    fun `the sources mark what is public of it`() {
        val marked = sources.classNames.flatMap { name ->
            val text = sources.source(name).orEmpty()
            MARKED.findAll(text).map { "$name.${nameIn(it.groupValues[1], name)}" }
        }
        val public = NxjDifferences.all.filter {
            classes.getValue(it.owner).let(::membersOf).getValue(it.member).isPublic
        }
        assertEquals(public.map { "${it.owner}.${it.name}" }.sorted(), marked.sorted())
    }

    @Test
    fun `compilers do not find it`() {
        val found = NxjDifferences.all.filterNot { difference ->
            val member = membersOf(classesOfBrick.getValue(difference.owner)).getValue(difference.member)
            if ('(' in difference.member) member.isSynthetic else member.isPrivate
        }
        assertEquals(emptyList(), found)
    }

    @Test
    fun `everything else stays as it is`() {
        val changed = classes.flatMap { (name, type) ->
            val missing = NxjDifferences.all.filter { it.owner == name }.map { it.member }
            val ofBrick = membersOf(classesOfBrick.getValue(name))
            membersOf(type).filter { (member, it) ->
                member !in missing &&
                    it.accessFlags != ofBrick[member]?.accessFlags
            }
                .keys
        }
        assertEquals(emptyList(), changed)
        assertSame(library.classFile("java/lang/Object"), library.classFilesOfBrick["java/lang/Object"])
    }

    private fun membersOf(type: JavaClass): Map<String, FieldOrMethod> =
        type.methods.associateBy { it.name + it.signature } + type.fields.associateBy { "${it.name}:${it.signature}" }

    /** The name of what [declaration] declares in the class [owner]. */
    private fun nameIn(declaration: String, owner: String): String {
        val name = declaration.substringBefore('(').substringBefore(" = ").trimEnd(';').substringAfterLast(' ')
        return if (name == owner.substringAfterLast('/')) "<init>" else name
    }

    private companion object {
        val MARKED = Regex("""@hidden\s+\*/\s+([^\n]+)""")
    }
}
