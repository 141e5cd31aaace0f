package robotran.robolang.translate

import org.apache.bcel.Const

/**
 * The limits of the leJOS linker. Source: `CodeUtilities`, `ClassRecord`, `MethodRecord` and `TinyVMConstants` of
 * `js.tinyvm` in leJOS 3.0, which reads class files with the same library.
 */
internal object TinyVmLimits {
    /** `long` arithmetic, remainders of decimal numbers, switches, and the wide forms of other instructions. */
    val REFUSED_INSTRUCTIONS: Set<Short> = setOf(
        Const.LOOKUPSWITCH,
        Const.TABLESWITCH,
        Const.WIDE,
        Const.GOTO_W,
        Const.JSR_W,
        Const.LDC_W,
        Const.FREM,
        Const.DREM,
        Const.LADD,
        Const.LSUB,
        Const.LMUL,
        Const.LDIV,
        Const.LREM,
        Const.LNEG,
        Const.LCMP,
        Const.LSHL,
        Const.LSHR,
        Const.LUSHR,
        Const.LAND,
        Const.LOR,
        Const.LXOR,
    )

    /** Instructions that are newer than the virtual machine, of 2006. */
    val UNKNOWN_INSTRUCTIONS: Set<Short> = setOf(Const.INVOKEDYNAMIC)

    const val LOCALS = 255
    const val OPERANDS = 255
    const val PARAMETERS = 16
    const val EXCEPTION_HANDLERS = 255
    const val CODE_BYTES = 0xFFFF
    const val METHODS = 255
    const val FIELDS = 255
    const val CONSTANTS = 256
    const val STRING_CHARACTERS = 255

    /** Array lengths are stored in 9 bits. Source: leJOS `memory.c`. */
    const val ARRAY_ELEMENTS = 511
}
