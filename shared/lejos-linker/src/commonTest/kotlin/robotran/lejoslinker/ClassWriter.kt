package robotran.lejoslinker

import robotran.language.Language
import robotran.lejoslinker.config.ImageOptions
import robotran.lejoslinker.messages.ImageMessages

/** Writes a class file of version 45 with fields, methods and constants as a test needs them. */
internal class ClassWriter(
    private val name: String,
    superName: String? = "java/lang/Object",
    private val flags: Int = PUBLIC,
    private val interfaces: List<String> = emptyList(),
) {
    private val constants = ArrayList<List<Int>>()
    private var nextIndex = 1
    private val indices = HashMap<List<Int>, Int>()
    private val fields = ArrayList<List<Int>>()
    private val methods = ArrayList<List<Int>>()
    private val thisIndex = type(name)
    private val superIndex = superName?.let(::type) ?: 0

    fun text(text: String): Int = text.encodeToByteArray().map { it.toInt() and 0xFF }.let {
        constant(listOf(1) + short(it.size) + it)
    }

    fun type(name: String): Int = constant(listOf(7) + short(text(name)))

    fun string(text: String): Int = constant(listOf(8) + short(text(text)))

    fun number(value: Int): Int = constant(listOf(3) + short(value ushr 16) + short(value))

    fun field(owner: String, name: String, descriptor: String): Int = member(9, owner, name, descriptor)

    fun method(owner: String, name: String, descriptor: String): Int = member(10, owner, name, descriptor)

    fun addField(name: String, descriptor: String, flags: Int = 0) {
        fields += short(flags) + short(text(name)) + short(text(descriptor)) + short(0)
    }

    /** Adds a method on source line 7; each number of [code] is a byte, null for a native or abstract method. */
    fun addMethod(
        name: String,
        descriptor: String,
        flags: Int,
        code: List<Int>?,
        stack: Int = 4,
        locals: Int = 4,
        handlers: List<List<Int>> = emptyList(),
    ) {
        val head = short(flags) + short(text(name)) + short(text(descriptor))
        if (code == null) {
            methods += head + short(0)
            return
        }
        val line = short(text("LineNumberTable")) + int(6) + short(1) + short(0) + short(LINE)
        val body = short(stack) + short(locals) + int(code.size) + code + short(handlers.size) +
            handlers.flatMap { it.flatMap(::short) } + short(1) + line
        methods += head + short(1) + short(text("Code")) + int(body.size) + body
    }

    /** Adds `main` with [code] and a return. */
    fun addMain(code: List<Int> = emptyList(), locals: Int = 4) =
        addMethod("main", "([Ljava/lang/String;)V", PUBLIC or STATIC, code + RETURN, locals = locals)

    fun bytes(): ByteArray {
        val interfaceIndices = interfaces.map(::type)
        val body = short(flags) + short(thisIndex) + short(superIndex) + short(interfaces.size) +
            interfaceIndices.flatMap(::short) + short(fields.size) + fields.flatten() + short(methods.size) +
            methods.flatten() + short(0)
        val all = listOf(0xCA, 0xFE, 0xBA, 0xBE) + short(3) + short(45) + short(nextIndex) + constants.flatten() + body
        return ByteArray(all.size) { all[it].toByte() }
    }

    private fun member(kind: Int, owner: String, name: String, descriptor: String): Int {
        val nameAndType = constant(listOf(12) + short(text(name)) + short(text(descriptor)))
        return constant(listOf(kind) + short(type(owner)) + short(nameAndType))
    }

    private fun constant(bytes: List<Int>): Int = indices.getOrPut(bytes) {
        constants += bytes
        nextIndex++
    }

    private fun int(value: Int) = short(value ushr 16) + short(value)

    companion object {
        const val PUBLIC = 0x21
        const val STATIC = 0x8
        const val NATIVE = 0x100
        const val INTERFACE = 0x601
        const val RETURN = 0xB1
        const val LINE = 7
    }
}

/** The two bytes of a number, high byte first. */
internal fun short(value: Int): List<Int> = listOf(value ushr 8 and 0xFF, value and 0xFF)

/** Links the class `Main` that [write] describes, with [others] by name. */
internal fun linkMain(
    others: Map<String, ByteArray> = emptyMap(),
    options: ImageOptions = ImageOptions(),
    write: ClassWriter.() -> Unit,
): ImageResult = linkLejosImage(
    mapOf("Main" to ClassWriter("Main").apply(write).bytes()) + others,
    Vectors.library,
    listOf("Main"),
    options,
    messages = ImageMessages.of(Language.ENGLISH),
)

/** The errors of a refused program as `class.method:line sentence`. */
internal fun errorsOf(result: ImageResult): List<String> = when (result) {
    is ImageResult.Success -> emptyList()

    is ImageResult.Failure -> result.errors.map {
        "${listOfNotNull(it.className, it.methodName).joinToString(".")}:${it.sourceLine} ${it.message}"
    }
}
