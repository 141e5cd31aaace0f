package robotran.nxjlibrary

import org.apache.bcel.Const
import org.apache.bcel.classfile.ConstantUtf8
import org.apache.bcel.classfile.JavaClass
import org.apache.bcel.generic.ClassGen
import org.apache.bcel.generic.InstructionFactory
import org.apache.bcel.generic.InstructionList
import org.apache.bcel.generic.MethodGen
import org.apache.bcel.generic.Type

/**
 * Runs classes of the library on this JVM, so that they can be held against those of the same name that it has itself.
 * The classes of `java.lang`, `java.util` and `java.io` that need no brick get the package `nxj.java` in front. Objects,
 * texts and what builds them, threads, exceptions, interfaces and the streams that others extend remain those of the
 * JVM. Native methods call those of the JVM.
 */
internal object LibraryOnJvm : ClassLoader(LibraryOnJvm::class.java.classLoader) {
    private const val FRONT = "nxj/"

    private val ofJvm = setOf(
        "java/lang/Object",
        "java/lang/String",
        "java/lang/Class",
        "java/lang/Enum",
        "java/lang/Thread",
        "java/lang/Throwable",
        "java/lang/StringBuilder",
        "java/lang/StringBuffer",
        "java/lang/System",
        "java/lang/Runtime",
        "java/lang/Shutdown",
        "java/io/InputStream",
        "java/io/OutputStream",
        "java/io/Reader",
        "java/io/Writer",
        "java/util/Timer",
        "java/util/TimerTask",
    )

    private val renamed: Set<String> = libraryClasses.filter { type ->
        val name = type.className.replace('.', '/')
        name.startsWith("java/") && !name.startsWith("java/awt/") && !type.isInterface && !type.isAnnotation &&
            !name.endsWith("Exception") && !name.endsWith("Error") && name.substringBefore('$') !in ofJvm
    }.map { it.className.replace('.', '/') }.toSet()

    private val named = Regex("""java/(?:lang|util|io)/[\w$]+""")

    /** The library's class [name], such as `java.util.ArrayList`. */
    fun type(name: String): Class<*> = loadClass("nxj.$name")

    /** A new object of the library's class [name]. */
    @Suppress("UNCHECKED_CAST")
    fun <T> make(name: String, vararg arguments: Any): T = type(name).constructors.first { maker ->
        maker.parameterCount == arguments.size &&
            maker.parameterTypes.zip(arguments).all { (wanted, given) -> fits(wanted, given) }
    }.newInstance(*arguments) as T

    override fun findClass(name: String): Class<*> {
        val original = name.removePrefix("nxj.").replace('.', '/')
        if (original !in renamed) throw ClassNotFoundException(name)
        val bytes = translated(parsed(original, library.classFiles.getValue(original)))
        return defineClass(name, bytes, 0, bytes.size)
    }

    private fun fits(wanted: Class<*>, given: Any) =
        wanted.isInstance(given) || wanted.kotlin.javaObjectType.isInstance(given)

    private fun translated(type: JavaClass): ByteArray {
        val pool = type.constantPool
        val constants = pool.constantPool
        for (index in 1 until pool.length) {
            val text = constants[index] as? ConstantUtf8 ?: continue
            val changed = named.replace(text.bytes) { if (it.value in renamed) FRONT + it.value else it.value }
            if (changed != text.bytes) pool.setConstant(index, ConstantUtf8(changed))
        }
        val original = type.className
        val changed = ClassGen(type)
        type.methods.filter { it.isNative }.forEach { native ->
            val method = MethodGen(native, FRONT + original, changed.constantPool)
            val code = InstructionList()
            var local = 0
            for (parameter in method.argumentTypes) {
                code.append(InstructionFactory.createLoad(parameter, local))
                local += parameter.size
            }
            code.append(
                InstructionFactory(changed).createInvoke(
                    original.removePrefix("nxj."),
                    method.name,
                    method.returnType,
                    method.argumentTypes,
                    Const.INVOKESTATIC,
                ),
            )
            code.append(InstructionFactory.createReturn(method.returnType as Type))
            val body = MethodGen(
                native.accessFlags and Const.ACC_NATIVE.toInt().inv(),
                method.returnType,
                method.argumentTypes,
                null,
                method.name,
                original,
                code,
                changed.constantPool,
            )
            body.setMaxStack()
            body.setMaxLocals()
            changed.replaceMethod(native, body.method)
        }
        return changed.javaClass.bytes
    }
}

/** Calls the static method [name] of this class with [arguments], whose types choose among those of that name. */
internal fun Class<*>.call(name: String, vararg arguments: Any): Any? = methods.single { method ->
    method.name == name && method.parameterTypes.map { it.kotlin.javaObjectType } ==
        arguments.map { it::class.javaObjectType }
}.invoke(null, *arguments)
