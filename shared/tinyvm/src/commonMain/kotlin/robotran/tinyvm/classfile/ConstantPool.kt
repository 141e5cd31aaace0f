package robotran.tinyvm.classfile

/**
 * The constants of a class file by index, from 1. Access to a missing constant or one of another kind throws
 * [DamagedClassFile].
 */
class ConstantPool(private val constants: List<Constant?>) {
    /** All constants in file order; those that take two indices occur once. */
    val all: List<Constant> get() = constants.filterNotNull()

    /** The text at [index]. */
    fun text(index: Int): String = (constant(index) as? Constant.Text ?: wrongKind()).text

    /** The internal name at [index]; an array class has its descriptor, such as `[I`. */
    fun className(index: Int): String = text((constant(index) as? Constant.ClassName ?: wrongKind()).textIndex)

    /** The same, null for index 0. */
    fun classNameOrNull(index: Int): String? = if (index == 0) null else className(index)

    /** The text of [constant]. */
    fun string(constant: Constant.StringText): String = text(constant.textIndex)

    /** The field or method at [index]. */
    fun member(index: Int): MemberReference {
        val member = constant(index) as? Constant.Member ?: wrongKind()
        val nameAndType = constant(member.nameAndTypeIndex) as? Constant.NameAndType ?: wrongKind()
        return MemberReference(
            member.kind,
            className(member.classIndex),
            text(nameAndType.nameIndex),
            text(nameAndType.descriptorIndex),
        )
    }

    /** The constant at [index]. */
    fun constant(index: Int): Constant = constants.getOrNull(index) ?: damaged("a constant that is not there")

    private fun wrongKind(): Nothing = damaged("a constant of the wrong kind")
}

internal fun readConstantPool(reader: ByteReader): ConstantPool {
    val size = reader.unsignedShort()
    val constants = ArrayList<Constant?>()
    constants += null
    while (constants.size < size) {
        val constant = readConstant(reader)
        constants += constant
        if (constant is Constant.Long || constant is Constant.Double) constants += null
    }
    return ConstantPool(constants)
}

private fun readConstant(reader: ByteReader): Constant = when (reader.unsignedByte()) {
    1 -> Constant.Text(readModifiedUtf8(reader.part(reader.unsignedShort())))
    3 -> Constant.Whole(reader.int())
    4 -> Constant.Decimal(Float.fromBits(reader.int()))
    5 -> Constant.Long(long(reader))
    6 -> Constant.Double(Double.fromBits(long(reader)))
    7 -> Constant.ClassName(reader.unsignedShort())
    8 -> Constant.StringText(reader.unsignedShort())
    9 -> Constant.Member(MemberKind.FIELD, reader.unsignedShort(), reader.unsignedShort())
    10 -> Constant.Member(MemberKind.METHOD, reader.unsignedShort(), reader.unsignedShort())
    11 -> Constant.Member(MemberKind.INTERFACE_METHOD, reader.unsignedShort(), reader.unsignedShort())
    12 -> Constant.NameAndType(reader.unsignedShort(), reader.unsignedShort())
    15 -> newer(reader, 3)
    16 -> newer(reader, 2)
    18 -> newer(reader, 4)
    else -> damaged("an unknown kind of constant")
}

private fun newer(reader: ByteReader, length: Int): Constant {
    reader.part(length)
    return Constant.Newer
}

private fun long(reader: ByteReader): Long = (reader.int().toLong() shl 32) or (reader.int().toLong() and 0xFFFFFFFFL)
