package robotran.tinyvm.classfile

import robotran.tinyvm.config.TinyVmLimits
import robotran.tinyvm.diagnostic.LinkError
import robotran.tinyvm.messages.ClassFileMessages

/** The result of [readClassFile]. */
sealed interface ClassFileResult {
    class Success(val classFile: ClassFile) : ClassFileResult

    class Failure(val refusal: LinkError) : ClassFileResult
}

/**
 * Reads a class file from arbitrary bytes; [expectedName], with dots, is the class name in the error. Code is not decoded,
 * and references between constants are not checked: see [DamagedClassFile].
 */
fun readClassFile(bytes: ByteArray, expectedName: String, messages: ClassFileMessages): ClassFileResult {
    fun refused(message: String) = ClassFileResult.Failure(LinkError(message, expectedName))
    if (bytes.size > TinyVmLimits.CLASS_FILE_BYTES) {
        return refused(messages.classFileTooLong(TinyVmLimits.CLASS_FILE_BYTES))
    }
    return try {
        val reader = ByteReader(bytes)
        if (bytes.size < HEADER_BYTES || reader.int() != MAGIC) return refused(messages.notAClassFile())
        reader.unsignedShort()
        if (reader.unsignedShort() !in TinyVmLimits.CLASS_FILE_VERSIONS) return refused(messages.classFileTooNew())
        ClassFileResult.Success(ClassFileReader(reader, readConstantPool(reader)).read())
    } catch (_: DamagedClassFile) {
        refused(messages.classFileDamaged())
    }
}

private const val MAGIC = 0xCAFEBABE.toInt()
private const val HEADER_BYTES = 8

/** Reads the part after the constant pool. */
private class ClassFileReader(private val reader: ByteReader, private val constants: ConstantPool) {
    fun read(): ClassFile {
        val flags = reader.unsignedShort()
        val name = constants.className(reader.unsignedShort())
        val superName = constants.classNameOrNull(reader.unsignedShort())
        val interfaces = List(reader.unsignedShort()) { constants.className(reader.unsignedShort()) }
        val fields = List(reader.unsignedShort()) { readField() }
        val methods = List(reader.unsignedShort()) { readMethod() }
        var sourceFile: String? = null
        readAttributes(reader) { attribute, content ->
            if (attribute == "SourceFile") sourceFile = constants.text(content.unsignedShort())
        }
        if (name.isEmpty() || name.startsWith("[")) damaged("a class without a name")
        return ClassFile(name, superName, flags, interfaces, fields, methods, constants, sourceFile)
    }

    private fun readField(): FieldEntry {
        val flags = reader.unsignedShort()
        val name = constants.text(reader.unsignedShort())
        val descriptor = checkedType(constants.text(reader.unsignedShort()))
        var constantIndex = 0
        readAttributes(reader) { attribute, content ->
            if (attribute == "ConstantValue") constantIndex = content.unsignedShort()
        }
        return FieldEntry(name, descriptor, flags, constantIndex)
    }

    private fun readMethod(): MethodEntry {
        val flags = reader.unsignedShort()
        val name = constants.text(reader.unsignedShort())
        val descriptor = constants.text(reader.unsignedShort())
        MethodDescriptor.of(descriptor)
        var code: CodeEntry? = null
        readAttributes(reader) { attribute, content ->
            if (attribute == "Code") code = readCode(content)
        }
        return MethodEntry(name, descriptor, flags, code)
    }

    private fun readCode(content: ByteReader): CodeEntry {
        val maxStack = content.unsignedShort()
        val maxLocals = content.unsignedShort()
        val bytes = content.copy(content.length())
        val handlers = List(content.unsignedShort()) {
            HandlerEntry(
                content.unsignedShort(),
                content.unsignedShort(),
                content.unsignedShort(),
                constants.classNameOrNull(content.unsignedShort()),
            )
        }
        val lines = ArrayList<Pair<Int, Int>>()
        val variables = ArrayList<LocalVariable>()
        readAttributes(content) { attribute, part ->
            when (attribute) {
                "LineNumberTable" -> repeat(part.unsignedShort()) {
                    lines +=
                        part.unsignedShort() to part.unsignedShort()
                }

                "LocalVariableTable" -> repeat(part.unsignedShort()) { variables += readVariable(part) }
            }
        }
        lines.sortBy { it.first }
        val table = LineTable(IntArray(lines.size) { lines[it].first }, IntArray(lines.size) { lines[it].second })
        return CodeEntry(maxStack, maxLocals, bytes, handlers, table, variables)
    }

    private fun readVariable(part: ByteReader): LocalVariable {
        val start = part.unsignedShort()
        val length = part.unsignedShort()
        val name = constants.text(part.unsignedShort())
        val descriptor = checkedType(constants.text(part.unsignedShort()))
        return LocalVariable(name, descriptor, part.unsignedShort(), start, start + length)
    }

    private fun readAttributes(from: ByteReader, read: (name: String, content: ByteReader) -> Unit) {
        repeat(from.unsignedShort()) {
            val name = constants.text(from.unsignedShort())
            read(name, from.part(from.length()))
        }
    }

    private fun checkedType(descriptor: String): String {
        if (endOfType(descriptor, 0) != descriptor.length) damaged("a wrong type")
        return descriptor
    }
}
