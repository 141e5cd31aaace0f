package robotran.lejoslinker.link

import robotran.lejoslinker.messages.ImageMessages
import robotran.lejoslinker.messages.tinyVm
import robotran.tinyvm.classfile.ClassFile
import robotran.tinyvm.classfile.ClassFileResult
import robotran.tinyvm.classfile.readClassFile

/** The class files of a program and of the library, each read once. Those of the program come first. */
internal class ClassFiles(
    program: Map<String, ByteArray>,
    private val library: Map<String, ByteArray>,
    private val errors: ErrorList,
    private val messages: ImageMessages,
) {
    private val own = LinkedHashMap<String, ClassFile>()
    private val ofLibrary = HashMap<String, ClassFile?>()

    init {
        for ((name, bytes) in program) {
            val file = read(bytes, name.removeSuffix(CLASS)) ?: continue
            if (own.put(file.name, file) != null) {
                errors.add(CodePlace(file.name), messages.tinyVm.duplicateClass(file.name.replace('/', '.')))
            }
        }
    }

    private val hasSeveralSources = own.values.mapNotNull { it.sourceFile }.distinct().size > 1

    /** The internal name of the program's first class; null if it has none. */
    val first: String? get() = own.keys.firstOrNull()

    /** The internal name of the program's first class with a main method; null if none has one. */
    val firstWithMain: String?
        get() = own.values.find { file -> file.methods.any { it.signature == MethodSelector.MAIN } }?.name

    fun isOwn(name: String): Boolean = name in own

    /** The class with the internal [name]; null if there is none, or only a damaged one. */
    fun find(name: String): ClassFile? =
        own[name] ?: ofLibrary.getOrPut(name) { library[name]?.let { read(it, name) }?.takeIf { it.name == name } }

    /** The source file of the program's class [name]; null if the program has only one source file. */
    fun sourceFileOf(name: String): String? = own[name]?.sourceFile?.takeIf { hasSeveralSources }

    private fun read(bytes: ByteArray, name: String): ClassFile? =
        when (val result = readClassFile(bytes, name.replace('/', '.'), messages.tinyVm)) {
            is ClassFileResult.Success -> result.classFile

            is ClassFileResult.Failure -> {
                errors.add(CodePlace(name), result.refusal.message)
                null
            }
        }

    private companion object {
        const val CLASS = ".class"
    }
}
