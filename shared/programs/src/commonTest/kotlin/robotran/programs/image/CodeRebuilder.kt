package robotran.programs.image

import robotran.tinyvm.classfile.ClassFile
import robotran.tinyvm.classfile.CodeEntry
import robotran.tinyvm.classfile.Constant

/**
 * Makes bytecode of a class file of the firmware's bytecode: each operand that is a number of the image becomes an index
 * into the constants of [builder].
 *
 * @param guide the code that the image's code was made of, for static types.
 */
internal class CodeRebuilder(
    private val image: BrickImage,
    private val names: ImageNames,
    private val rebuilder: ImageRebuilder,
    private val builder: ClassFileBuilder,
    private val original: ClassFile,
    private val method: ImageMethod,
    private val guide: CodeEntry,
) {
    private val code = image.code(method.codeAt, guide.bytes.size)
    private val result = code.copyOf()
    private val pool = original.constants

    fun reserveLoadedConstants() = forEachInstruction { at, opcode -> if (opcode == LDC) loaded(at) }

    fun rebuild(): BuiltCode {
        forEachInstruction(::rebuild)
        val handlers = method.handlers.map {
            ImageHandler(it.start, it.end, it.target, builder.type(names.classNamed(it.type)))
        }
        return BuiltCode(result, method.stack, method.locals, handlers)
    }

    private fun rebuild(at: Int, opcode: Int) {
        val original = guide.bytes[at].toInt() and 0xFF
        when (opcode) {
            LDC -> result[at + 1] = loaded(at).also { check(it <= 0xFF) { "too many constants" } }
            LDC2_W -> set(at + 1, loadedWide(at))
            NEW, CHECKCAST, INSTANCEOF -> set(at + 1, builder.type(names.classNamed(code[at + 2])))

            in GETSTATIC..PUTSTATIC -> {
                val field = rebuilder.staticField(code[at + 1], code[at + 2])
                set(at + 1, builder.field(field.owner, field.name, field.descriptor))
            }

            in GETFIELD..PUTFIELD -> {
                val owner = classNumber(pool.member(guideOperand(at)).owner)
                val field = rebuilder.fieldAt(owner, image.fieldOf(operand(at)))
                set(at + 1, builder.field(field.owner, field.name, field.descriptor))
            }

            INVOKESPECIAL, INVOKESTATIC -> {
                val called = image.classes[code[at + 1]].methods[code[at + 2]]
                val owner = names.classNamed(code[at + 1])
                set(
                    at + 1,
                    builder.method(owner, names.methodNamed(called.signature), names.descriptorOf(called.signature)),
                )
            }

            INVOKEVIRTUAL -> invoke(at, isInterface = original == INVOKEINTERFACE)

            NEWARRAY -> {
                if (original == ANEWARRAY) {
                    check(code[at + 1] == ImageTypes.REFERENCE && code[at + 2] == 0) { "anewarray" }
                    result[at] = ANEWARRAY
                    set(at + 1, builder.type(names.renamed(pool.className(guideOperand(at)))))
                }
            }

            MULTIANEWARRAY -> {
                val type = pool.className(guideOperand(at))
                check(type.takeWhile { it == '[' }.length == code[at + 2]) { "multianewarray" }
                set(at + 1, builder.type(names.renamed(type)))
            }
        }
    }

    /** A virtual call knows the number of words of its arguments and the signature, but no class. */
    private fun invoke(at: Int, isInterface: Boolean) {
        val signature = operand(at) and SIGNATURE
        val words = operand(at) shr WORDS_SHIFT
        val receiver = pool.member(guideOperand(at)).owner
        val owner = names.renamed(receiver)
        val name = names.methodNamed(signature)
        val descriptor = names.descriptorOf(signature)
        if (isInterface) {
            check(code[at + 3] == 0 && code[at + 4] == 0) { "invokeinterface" }
            result[at] = INVOKEINTERFACE
            set(at + 1, builder.interfaceMethod(owner, name, descriptor))
            result[at + 3] = words + 1
        } else {
            set(at + 1, builder.method(owner, name, descriptor))
        }
    }

    private fun loaded(at: Int): Int {
        val constant = image.constant(code[at + 1])
        return when (constant.type) {
            ImageTypes.REFERENCE -> builder.string(textOf(constant))
            ImageTypes.of("F") -> builder.decimal(lastInt(constant))
            else -> builder.whole(lastInt(constant))
        }
    }

    private fun loadedWide(at: Int): Int {
        val value = lastInt(image.constant(operand(at)))
        val isDouble = pool.constant(guideOperand(at)) is Constant.Double
        return if (isDouble) builder.double(Float.fromBits(value).toDouble()) else builder.long(value.toLong())
    }

    /** The firmware makes one character of each byte. */
    private fun textOf(constant: ImageConstant): String =
        constant.value.map { (it.toInt() and 0xFF).toChar() }.joinToString("")

    private fun lastInt(constant: ImageConstant): Int =
        constant.value.takeLast(4).fold(0) { bits, byte -> bits shl 8 or (byte.toInt() and 0xFF) }

    private fun classNumber(originalName: String): Int = names.originals.indexOfFirst { it.name == originalName }

    private fun operand(at: Int): Int = code[at + 1] shl 8 or code[at + 2]

    private fun guideOperand(at: Int): Int =
        (guide.bytes[at + 1].toInt() and 0xFF shl 8) or (guide.bytes[at + 2].toInt() and 0xFF)

    private fun set(at: Int, value: Int) {
        result[at] = value shr 8
        result[at + 1] = value and 0xFF
    }

    private fun forEachInstruction(act: (at: Int, opcode: Int) -> Unit) {
        var at = 0
        while (at < code.size) {
            val opcode = code[at]
            act(at, opcode)
            at += if (opcode == NEWARRAY) lengthOf(guide.bytes[at].toInt() and 0xFF) else lengthOf(opcode)
        }
    }

    /** Of an instruction of the firmware, in which an interface call is a virtual one and two `nop`. */
    private fun lengthOf(opcode: Int): Int = when (opcode) {
        16, LDC, in 21..25, in 54..58, 169, NEWARRAY -> 2
        17, LDC2_W, 132, in 153..168, in GETSTATIC..INVOKESTATIC, in OTHERS_WITH_INDEX, 198, 199 -> 3
        MULTIANEWARRAY -> 4
        else -> 1
    }

    private companion object {
        const val LDC = 18
        const val LDC2_W = 20
        const val GETSTATIC = 178
        const val PUTSTATIC = 179
        const val GETFIELD = 180
        const val PUTFIELD = 181
        const val INVOKEVIRTUAL = 182
        const val INVOKESPECIAL = 183
        const val INVOKESTATIC = 184
        const val INVOKEINTERFACE = 185
        const val NEW = 187
        const val NEWARRAY = 188
        const val ANEWARRAY = 189
        const val CHECKCAST = 192
        const val INSTANCEOF = 193
        const val MULTIANEWARRAY = 197
        val OTHERS_WITH_INDEX = setOf(NEW, ANEWARRAY, CHECKCAST, INSTANCEOF)
        const val SIGNATURE = 0xFFF
        const val WORDS_SHIFT = 12
    }
}
