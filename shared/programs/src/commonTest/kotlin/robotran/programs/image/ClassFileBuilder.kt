package robotran.programs.image

/** Writes class files of version 45.3. Constants that `ldc` loads must be asked for first, because it has a byte for their index. */
internal class ClassFileBuilder(name: String, superName: String?, private val flags: Int, interfaces: List<String>) {
    private val constants = ArrayList<List<Int>>()
    private var nextIndex = 1
    private val known = HashMap<Any, Int>()
    private val waitingTexts = ArrayList<Pair<Int, String>>()
    private val fields = ArrayList<Int>()
    private val methods = ArrayList<Int>()
    private var fieldCount = 0
    private var methodCount = 0
    private val names = Triple(name, superName, interfaces)

    fun whole(value: Int): Int = constant(listOf(3) + int(value))

    fun decimal(bits: Int): Int = constant(listOf(4) + int(bits))

    fun long(value: Long): Int = wide(listOf(5) + int((value ushr 32).toInt()) + int(value.toInt()))

    fun double(value: Double): Int =
        value.toBits().let { wide(listOf(6) + int((it ushr 32).toInt()) + int(it.toInt())) }

    /** Its text gets an index later. */
    fun string(text: String): Int = known.getOrPut("string" to text) {
        constants += listOf(8, 0, 0)
        waitingTexts += constants.lastIndex to text
        nextIndex++
    }

    fun type(name: String): Int = constant(listOf(7) + short(text(name)))

    fun field(owner: String, name: String, descriptor: String): Int = member(9, owner, name, descriptor)

    fun method(owner: String, name: String, descriptor: String): Int = member(10, owner, name, descriptor)

    fun interfaceMethod(owner: String, name: String, descriptor: String): Int = member(11, owner, name, descriptor)

    fun addField(name: String, descriptor: String, flags: Int) {
        fields += short(flags) + short(text(name)) + short(text(descriptor)) + short(0)
        fieldCount++
    }

    /** @param code null for an abstract or native method. */
    fun addMethod(name: String, descriptor: String, flags: Int, code: BuiltCode?) {
        methods += short(flags) + short(text(name)) + short(text(descriptor))
        methodCount++
        if (code == null) {
            methods += short(0)
            return
        }
        val handlers = code.handlers.flatMap { handler ->
            short(handler.start) + short(handler.end) + short(handler.target) + short(handler.type)
        }
        val body = short(code.stack) + short(code.locals) + int(code.bytes.size) + code.bytes.toList() +
            short(code.handlers.size) + handlers + short(0)
        methods += short(1) + short(text("Code")) + int(body.size) + body
    }

    fun build(): ByteArray {
        val (name, superName, interfaces) = names
        val head = short(flags) + short(type(name)) + short(superName?.let(::type) ?: 0) +
            short(interfaces.size) + interfaces.flatMap { short(type(it)) }
        for ((place, text) in waitingTexts) constants[place] = listOf(8) + short(text(text))
        val all = listOf(0xCA, 0xFE, 0xBA, 0xBE) + short(3) + short(45) + short(nextIndex) + constants.flatten() +
            head + short(fieldCount) + fields + short(methodCount) + methods + short(0)
        return ByteArray(all.size) { all[it].toByte() }
    }

    private fun text(text: String): Int = constant(
        text.flatMap { modifiedUtf8(it.code) }.let { listOf(1) + short(it.size) + it },
    )

    private fun modifiedUtf8(code: Int): List<Int> = when (code) {
        in 1..0x7F -> listOf(code)
        in 0..0x7FF -> listOf(0xC0 or (code shr 6), 0x80 or (code and 0x3F))
        else -> listOf(0xE0 or (code shr 12), 0x80 or (code shr 6 and 0x3F), 0x80 or (code and 0x3F))
    }

    private fun member(kind: Int, owner: String, name: String, descriptor: String): Int {
        val nameAndType = constant(listOf(12) + short(text(name)) + short(text(descriptor)))
        return constant(listOf(kind) + short(type(owner)) + short(nameAndType))
    }

    private fun wide(bytes: List<Int>): Int = known.getOrPut(bytes) {
        constants += bytes
        nextIndex.also { nextIndex += 2 }
    }

    private fun constant(bytes: List<Int>): Int = known.getOrPut(bytes) {
        constants += bytes
        nextIndex++
    }
}

/** @property handlers as in an image, but with the pool index of the class as type. */
internal class BuiltCode(val bytes: IntArray, val stack: Int, val locals: Int, val handlers: List<ImageHandler>)

/** The two bytes of a number, high byte first. */
internal fun short(value: Int): List<Int> = listOf(value ushr 8 and 0xFF, value and 0xFF)

private fun int(value: Int): List<Int> = short(value ushr 16) + short(value)
