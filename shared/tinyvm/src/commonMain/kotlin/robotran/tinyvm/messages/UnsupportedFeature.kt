package robotran.tinyvm.messages

/** Java features that TinyVM does not support. */
enum class UnsupportedFeature {
    SWITCH,
    LONG_ARITHMETIC,
    DECIMAL_REMAINDER,
    FAR_JUMP,
    MANY_LOCALS,
    MANY_CONSTANTS,
    INVOKE_DYNAMIC,
    ARRAY_TEST,
    CLASS_LITERAL,
    INTERFACE_CODE,
    NESTED_FINALLY,
}
