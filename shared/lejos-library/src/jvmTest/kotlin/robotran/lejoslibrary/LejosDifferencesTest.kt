package robotran.lejoslibrary

import robotran.tinyvm.config.LejosVersion
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class LejosDifferencesTest {
    private val classes = libraryClassFiles.associateBy { it.className.replace('.', '/') }

    @Test
    fun `every difference names a class or a member that programs can use`() {
        assertEquals(emptyList(), LejosDifferences.all.filterNot(::isUsable))
    }

    @Test
    fun `nothing is named twice`() {
        val named = LejosDifferences.all.map { it.owner to it.member }
        assertEquals(named.distinct(), named)
    }

    @Test
    fun `few exceptions can have a text with leJOS, too`() {
        val withText = classes.keys.filter { isThrowable(it) && "<init>(Ljava/lang/String;)V" in membersOf(it) }
        val onlyHere = LejosDifferences.all.filter { it.instead == LejosRemedy.EXCEPTION_WITHOUT_TEXT }
        assertEquals(
            setOf(
                "java/io/IOException",
                "java/lang/Exception",
                "java/lang/NoClassDefFoundError",
                "java/lang/Throwable",
            ),
            withText.toSet() - onlyHere.map { it.owner }.toSet(),
        )
    }

    @Test
    fun `what came with a version is in that version and in later ones`() {
        val message = LejosDifferences.all.single { it.owner == "josx/platform/rcx/Message" }
        assertFalse(message.isIn(LejosVersion.V2_1))
        assertTrue(message.isIn(LejosVersion.V3_0))
    }

    @Test
    fun `what no version has is in none`() {
        val builder = LejosDifferences.all.single { it.owner == "java/lang/StringBuilder" }
        assertTrue(LejosVersion.entries.none(builder::isIn))
    }

    private fun isUsable(difference: LejosDifference): Boolean {
        val type = classes[difference.owner] ?: return false
        return type.isPublic && (difference.member.isEmpty() || difference.member in membersOf(difference.owner))
    }

    /** The public methods, constructors and fields of the class [name] and of all that it implements. */
    private fun membersOf(name: String): Set<String> {
        val type = classes.getValue(name)
        val methods = type.methods.filter { it.isPublic }.map { it.name + it.signature }
        val fields = type.fields.filter { it.isPublic }.map { "${it.name}:${it.signature}" }
        return (methods + fields).toSet() + type.interfaceNames.flatMap { membersOf(it.replace('.', '/')) }
    }

    private fun isThrowable(name: String): Boolean = name == "java/lang/Throwable" ||
        (name != "java/lang/Object" && isThrowable(classes.getValue(name).superclassName.replace('.', '/')))
}
