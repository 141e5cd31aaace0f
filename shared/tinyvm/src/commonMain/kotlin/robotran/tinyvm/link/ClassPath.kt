package robotran.tinyvm.link

import robotran.tinyvm.classfile.ClassFile
import robotran.tinyvm.classfile.ClassFileResult
import robotran.tinyvm.classfile.readClassFile
import robotran.tinyvm.diagnostic.LinkException
import robotran.tinyvm.messages.TinyVmMessages

/** The class files for linking a program: all of its own, and those of the [library] that are looked up. */
internal class ClassPath(
    program: Map<String, ByteArray>,
    private val library: Map<String, ByteArray>,
    private val messages: TinyVmMessages,
) {
    private val own = LinkedHashMap<String, ClassFile>()

    /** The internal names of the program's classes. */
    val ownNames: Set<String> get() = own.keys

    init {
        for ((name, bytes) in program) {
            val file = read(bytes, name)
            if (own.put(file.name, file) != null) {
                CodeLocation(file.name).reject(messages.duplicateClass(file.name.replace('/', '.')))
            }
        }
    }

    /** The source file of the program's class [name]; null if the program has only one source file. */
    fun sourceFileOf(name: String): String? = own[name]?.sourceFile?.takeIf { hasSeveralSources }

    private val hasSeveralSources: Boolean by lazy(LazyThreadSafetyMode.NONE) {
        own.values.mapNotNull { it.sourceFile }.distinct().size > 1
    }

    fun isOwn(name: String): Boolean = name in own

    /** The class with the internal name [name]; null if neither the program nor the library has it. */
    fun find(name: String): ClassFile? = own[name] ?: library[name]?.let { read(it, name) }?.takeIf { it.name == name }

    private fun read(bytes: ByteArray, name: String): ClassFile =
        when (val result = readClassFile(bytes, name.removeSuffix(".class").replace('/', '.'), messages)) {
            is ClassFileResult.Success -> result.classFile
            is ClassFileResult.Failure -> throw LinkException(result.refusal)
        }
}
