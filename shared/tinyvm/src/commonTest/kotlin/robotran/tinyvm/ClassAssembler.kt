package robotran.tinyvm

import robotran.language.Language
import robotran.tinyvm.messages.TinyVmMessages

/** Builds a class file of version 45 from constants and bytecode. */
internal class ClassAssembler(name: String, superName: String?, private val flags: Int = 0x21) {
    private val constants = ArrayList<List<Int>>()
    private val known = HashMap<List<Int>, Int>()
    private val fields = ArrayList<List<Int>>()
    private val methods = ArrayList<List<Int>>()
    private val thisIndex = classConstant(name)
    private val superIndex = superName?.let { classConstant(it) } ?: 0

    fun text(text: String): Int = constant(listOf(1) + short(text.length) + text.map { it.code })

    fun classConstant(name: String): Int = constant(listOf(7) + short(text(name)))

    fun number(value: Int): Int = constant(
        listOf(
            3,
            value ushr 24,
            value ushr 16 and 0xFF,
            value ushr 8 and 0xFF,
            value and 0xFF,
        ),
    )

    fun decimal(value: Float): Int = value.toBits().let {
        constant(
            listOf(
                4,
                it ushr 24,
                it ushr 16 and 0xFF,
                it ushr 8 and 0xFF,
                it and 0xFF,
            ),
        )
    }

    fun method(owner: String, name: String, descriptor: String): Int = member(10, owner, name, descriptor)

    fun field(owner: String, name: String, descriptor: String): Int = member(9, owner, name, descriptor)

    fun addField(name: String, descriptor: String, flags: Int = 0) {
        fields += short(flags) + short(text(name)) + short(text(descriptor)) + short(0)
    }

    /** Adds a method; each number of [code] is a byte, null for native and abstract methods. */
    fun addMethod(name: String, descriptor: String, flags: Int, code: List<Int>?, stack: Int = 8, locals: Int = 8) {
        val head = short(flags) + short(text(name)) + short(text(descriptor))
        methods += if (code == null) {
            head + short(0)
        } else {
            head + short(
                1,
            ) + short(text("Code")) + int(code.size + 12) + short(stack) + short(locals) + int(code.size) +
                code +
                short(0) +
                short(0)
        }
    }

    fun assemble(): ByteArray {
        val body = short(flags) + short(thisIndex) + short(superIndex) + short(0) +
            short(fields.size) + fields.flatten() + short(methods.size) + methods.flatten() + short(0)
        val all =
            listOf(0xCA, 0xFE, 0xBA, 0xBE) + short(3) + short(45) + short(constants.size + 1) + constants.flatten() +
                body
        return ByteArray(all.size) { all[it].toByte() }
    }

    private fun member(kind: Int, owner: String, name: String, descriptor: String): Int {
        val nameAndType = constant(listOf(12) + short(text(name)) + short(text(descriptor)))
        return constant(listOf(kind) + short(classConstant(owner)) + short(nameAndType))
    }

    private fun constant(bytes: List<Int>): Int = known.getOrPut(bytes) {
        constants += bytes
        constants.size
    }

    private fun int(value: Int) = short(value ushr 16) + short(value)
}

/** The two bytes of a number, high byte first. */
internal fun short(value: Int): List<Int> = listOf(value ushr 8 and 0xFF, value and 0xFF)

/** The smallest class library that a program can be linked with. */
internal val minLibrary: Map<String, ByteArray> by lazy {
    val exceptions = listOf(
        "Error",
        "NullPointerException",
        "ArithmeticException",
        "ArrayIndexOutOfBoundsException",
        "ClassCastException",
        "IllegalArgumentException",
        "IllegalStateException",
        "IllegalMonitorStateException",
        "InterruptedException",
        "NoSuchMethodError",
        "OutOfMemoryError",
        "StackOverflowError",
    )
    val plain = exceptions.associate {
        "java/lang/$it" to
            ClassAssembler("java/lang/$it", "java/lang/Throwable").assemble()
    }
    val text = ClassAssembler("java/lang/String", "java/lang/Object").apply { addField("characters", "[C") }
    val thread = ClassAssembler("java/lang/Thread", "java/lang/Object", 0x421).apply {
        addMethod("run", "()V", 0x401, null)
    }
    val rom = ClassAssembler("josx/platform/rcx/ROM", "java/lang/Object").apply {
        addMethod("call", "(SSSS)V", 0x109, null)
    }
    plain + mapOf(
        "java/lang/Object" to ClassAssembler("java/lang/Object", null).assemble(),
        "java/lang/Throwable" to ClassAssembler("java/lang/Throwable", "java/lang/Object").assemble(),
        "java/lang/String" to text.assemble(),
        "java/lang/Thread" to thread.assemble(),
        "josx/platform/rcx/ROM" to rom.assemble(),
    )
}

/** Links a main method with [code], which can add constants to the [ClassAssembler]. */
internal fun linkMain(code: ClassAssembler.() -> List<Int>): TinyVmResult {
    val assembler = ClassAssembler("Main", "java/lang/Object")
    assembler.addMethod("show", "(I)V", 0x9, showing(assembler))
    assembler.addMethod("main", "([Ljava/lang/String;)V", 0x9, assembler.code())
    return linkTinyVm(
        "Main",
        mapOf("Main" to assembler.assemble()),
        minLibrary,
        messages = TinyVmMessages.of(Language.ENGLISH),
    )
}

private fun showing(assembler: ClassAssembler): List<Int> = with(assembler) {
    val call = method("josx/platform/rcx/ROM", "call", "(SSSS)V")
    listOf(0x11) + short(0x1FF2) + listOf(0x11) + short(0x3001) + listOf(0x1A, 0x11) + short(0x3002) + listOf(0xB8) +
        short(call) +
        0xB1
}

/** Code that shows the topmost number. */
internal fun ClassAssembler.show(): List<Int> = listOf(0xB8) + short(method("Main", "show", "(I)V"))
