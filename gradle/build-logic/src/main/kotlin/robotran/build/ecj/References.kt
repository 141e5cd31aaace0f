package robotran.build.ecj

import org.objectweb.asm.ClassReader
import org.objectweb.asm.ClassVisitor
import org.objectweb.asm.FieldVisitor
import org.objectweb.asm.MethodVisitor
import org.objectweb.asm.Opcodes

/** Some classes with their members, and what their code refers to. */
internal class References {
    private class Known(val supertypes: List<String>, val members: MutableSet<String> = mutableSetOf())

    private val classes = mutableMapOf<String, Known>()
    private val uses = mutableListOf<Use>()

    private data class Use(val owner: String, val member: String?, val from: String)

    /** Adds a class that others may refer to. */
    fun addFramework(classFile: ByteArray) = ClassReader(classFile).accept(Members(), ClassReader.SKIP_CODE)

    /** Adds a class that others may refer to, and whose own references are looked at. */
    fun add(classFile: ByteArray) {
        addFramework(classFile)
        ClassReader(classFile).accept(Uses(), ClassReader.SKIP_DEBUG or ClassReader.SKIP_FRAMES)
    }

    /** What is referred to and is not there, each with a method that does so. */
    fun missing(): List<String> = uses.filterNot { use -> if (use.member == null) use.owner in classes else has(use.owner, use.member) }
        .map { use -> "${listOfNotNull(use.owner, use.member).joinToString(".")}, used by ${use.from}" }.distinct().sorted()

    private fun has(owner: String, member: String): Boolean {
        val known = classes[owner] ?: return false
        return member in known.members || known.supertypes.any { has(it, member) }
    }

    private inner class Members : ClassVisitor(Opcodes.ASM9) {
        private lateinit var known: Known

        override fun visit(version: Int, access: Int, name: String, signature: String?, superName: String?, interfaces: Array<String>?) {
            // An interface has the methods of Object, too.
            known = Known(listOfNotNull(superName) + interfaces.orEmpty())
            classes[name] = known
        }

        override fun visitField(access: Int, name: String, descriptor: String, signature: String?, value: Any?): FieldVisitor? {
            known.members += name
            return null
        }

        override fun visitMethod(
            access: Int,
            name: String,
            descriptor: String,
            signature: String?,
            exceptions: Array<String>?,
        ): MethodVisitor? {
            known.members += name + descriptor
            return null
        }
    }

    private inner class Uses : ClassVisitor(Opcodes.ASM9) {
        private var className = ""

        override fun visit(version: Int, access: Int, name: String, signature: String?, superName: String?, interfaces: Array<String>?) {
            className = name
            (listOfNotNull(superName) + interfaces.orEmpty()).forEach { uses += Use(it, null, name) }
        }

        override fun visitMethod(
            access: Int,
            name: String,
            descriptor: String,
            signature: String?,
            exceptions: Array<String>?,
        ): MethodVisitor = CodeUses("$className.$name")
    }

    private inner class CodeUses(private val from: String) : MethodVisitor(Opcodes.ASM9) {
        override fun visitMethodInsn(opcode: Int, owner: String, name: String, descriptor: String, isInterface: Boolean) =
            use(owner, name + descriptor)

        override fun visitFieldInsn(opcode: Int, owner: String, name: String, descriptor: String) = use(owner, name)

        override fun visitTypeInsn(opcode: Int, type: String) = use(type, null)

        private fun use(owner: String, member: String?) {
            // Arrays have nothing but what every object has.
            if (!owner.startsWith('[')) uses += Use(owner, member, from)
        }
    }
}
