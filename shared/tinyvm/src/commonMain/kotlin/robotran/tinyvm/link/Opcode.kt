package robotran.tinyvm.link

/**
 * The numbers of bytecodes, as far as they are not in [SIMPLE_INSTRUCTIONS]. Source: The Java Virtual Machine
 * Specification, chapter 6.
 */
internal object Opcode {
    const val LDC = 18
    const val LDC_W = 19
    const val LDC2_W = 20
    const val ILOAD = 21
    const val ALOAD = 25
    const val ILOAD_0 = 26
    const val ALOAD_3 = 45
    const val IALOAD = 46
    const val SALOAD = 53
    const val ISTORE = 54
    const val ASTORE = 58
    const val ISTORE_0 = 59
    const val ASTORE_3 = 78
    const val IASTORE = 79
    const val SASTORE = 86
    const val POP = 87
    const val POP2 = 88
    const val DUP = 89
    const val DUP_X1 = 90
    const val DUP_X2 = 91
    const val DUP2 = 92
    const val DUP2_X1 = 93
    const val DUP2_X2 = 94
    const val SWAP = 95
    const val IINC = 132
    const val IFEQ = 153
    const val IFLE = 158
    const val IF_ICMPEQ = 159
    const val IF_ICMPLE = 164
    const val IF_ACMPEQ = 165
    const val IF_ACMPNE = 166
    const val GOTO = 167
    const val JSR = 168
    const val RET = 169
    const val TABLESWITCH = 170
    const val LOOKUPSWITCH = 171
    const val IRETURN = 172
    const val ARETURN = 176
    const val RETURN = 177
    const val GETSTATIC = 178
    const val PUTSTATIC = 179
    const val GETFIELD = 180
    const val PUTFIELD = 181
    const val INVOKEVIRTUAL = 182
    const val INVOKESPECIAL = 183
    const val INVOKESTATIC = 184
    const val INVOKEINTERFACE = 185
    const val INVOKEDYNAMIC = 186
    const val NEW = 187
    const val NEWARRAY = 188
    const val ANEWARRAY = 189
    const val ARRAYLENGTH = 190
    const val ATHROW = 191
    const val CHECKCAST = 192
    const val INSTANCEOF = 193
    const val MONITORENTER = 194
    const val MONITOREXIT = 195
    const val WIDE = 196
    const val MULTIANEWARRAY = 197
    const val IFNULL = 198
    const val IFNONNULL = 199
    const val GOTO_W = 200
    const val JSR_W = 201
}
