package robotran.tinyvm.link

import robotran.tinyvm.messages.UnsupportedFeature

/**
 * The opcodes that leJOS's linker rejects, with what they stand for in Java; 114 and 115 are `frem` and `drem`, the
 * others without a name calculate with long numbers or compare them. Source: leJOS `CodeUtilities.java`.
 */
val UNSUPPORTED_OPCODES: Map<Int, UnsupportedFeature> = mapOf(
    Opcode.TABLESWITCH to UnsupportedFeature.SWITCH,
    Opcode.LOOKUPSWITCH to UnsupportedFeature.SWITCH,
    Opcode.WIDE to UnsupportedFeature.MANY_LOCALS,
    Opcode.LDC_W to UnsupportedFeature.MANY_CONSTANTS,
    Opcode.GOTO_W to UnsupportedFeature.FAR_JUMP,
    Opcode.JSR_W to UnsupportedFeature.FAR_JUMP,
    Opcode.INVOKEDYNAMIC to UnsupportedFeature.INVOKE_DYNAMIC,
    114 to UnsupportedFeature.DECIMAL_REMAINDER,
    115 to UnsupportedFeature.DECIMAL_REMAINDER,
) + listOf(97, 101, 105, 109, 113, 117, 121, 123, 125, 127, 129, 131, 148).associateWith {
    UnsupportedFeature.LONG_ARITHMETIC
}
