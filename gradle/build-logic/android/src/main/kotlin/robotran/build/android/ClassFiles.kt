package robotran.build.android

import org.objectweb.asm.ClassReader
import org.objectweb.asm.ClassVisitor
import org.objectweb.asm.FieldVisitor
import org.objectweb.asm.MethodVisitor
import org.objectweb.asm.Opcodes
import java.io.File
import java.util.zip.ZipFile

/** The class files of a jar or folder. */
internal fun classFiles(file: File): List<ByteArray> = when {
    file.isDirectory -> file.walk().filter { it.extension == "class" }.map { it.readBytes() }.toList()

    else -> ZipFile(file).use { jar ->
        jar.entries().asSequence().filter { it.name.endsWith(".class") }.map { entry ->
            jar.getInputStream(entry).use { it.readBytes() }
        }.toList()
    }
}

/** Adds the class in [classFile] as a declaration. */
internal fun UsedApi.declare(classFile: ByteArray) = ClassReader(classFile).accept(Members(this), ClassReader.SKIP_CODE)

/** Adds the class in [classFile] as a declaration, and the references in its code. */
internal fun UsedApi.declareAndRead(classFile: ByteArray) {
    declare(classFile)
    ClassReader(classFile).accept(Uses(this), ClassReader.SKIP_DEBUG or ClassReader.SKIP_FRAMES)
}

private class Members(private val known: UsedApi) : ClassVisitor(Opcodes.ASM9) {
    private var name = ""
    private var supertypes = emptyList<String>()
    private val members = mutableSetOf<String>()

    override fun visit(
        version: Int,
        access: Int,
        name: String,
        signature: String?,
        superName: String?,
        interfaces: Array<String>?,
    ) {
        this.name = name
        // Interfaces also have the methods of Object.
        supertypes = listOfNotNull(superName) + interfaces.orEmpty()
    }

    override fun visitField(
        access: Int,
        name: String,
        descriptor: String,
        signature: String?,
        value: Any?,
    ): FieldVisitor? {
        members += name
        return null
    }

    override fun visitMethod(
        access: Int,
        name: String,
        descriptor: String,
        signature: String?,
        exceptions: Array<String>?,
    ): MethodVisitor? {
        members += name + descriptor
        return null
    }

    override fun visitEnd() = known.declare(name, supertypes, members)
}

private class Uses(private val known: UsedApi) : ClassVisitor(Opcodes.ASM9) {
    private var className = ""

    override fun visit(
        version: Int,
        access: Int,
        name: String,
        signature: String?,
        superName: String?,
        interfaces: Array<String>?,
    ) {
        className = name
        (listOfNotNull(superName) + interfaces.orEmpty()).forEach { known.use(it, null, name) }
    }

    override fun visitMethod(
        access: Int,
        name: String,
        descriptor: String,
        signature: String?,
        exceptions: Array<String>?,
    ): MethodVisitor = CodeUses("$className.$name")

    private inner class CodeUses(private val from: String) : MethodVisitor(Opcodes.ASM9) {
        override fun visitMethodInsn(
            opcode: Int,
            owner: String,
            name: String,
            descriptor: String,
            isInterface: Boolean,
        ) = known.use(owner, name + descriptor, from)

        override fun visitFieldInsn(opcode: Int, owner: String, name: String, descriptor: String) =
            known.use(owner, name, from)

        override fun visitTypeInsn(opcode: Int, type: String) = known.use(type, null, from)
    }
}
